"""Recorded runs at a page of their own."""
