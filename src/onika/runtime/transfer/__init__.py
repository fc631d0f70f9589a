"""The inputs of hardware tasks: fresh, finite, and without jumps."""
