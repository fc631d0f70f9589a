"""Recordings that a test writes, and the replay of all of them."""
