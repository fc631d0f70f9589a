"""Subsystems changed by hand while they live."""
