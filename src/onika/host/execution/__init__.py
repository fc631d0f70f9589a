"""The execution of a subsystem: its tasks are spawned, switched, killed and followed, whoever decides about them."""
