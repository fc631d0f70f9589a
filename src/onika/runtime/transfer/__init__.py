"""What a hardware task is given: fresh, finite, and without jumps."""
