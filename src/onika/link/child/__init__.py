"""A runtime as a child of this program: launched, watched, and ended with it."""
