"""A run as it is recorded."""
