"""A sequence of 24 actions that succeed at once."""
