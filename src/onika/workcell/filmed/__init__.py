"""Worlds from files with their cameras: a process of its own renders what they see (decision 50)."""
