"""Worlds that are files: read, composed with MuJoCo, and driven (requirement X19)."""
