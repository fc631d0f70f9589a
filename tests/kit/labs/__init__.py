"""Laboratories, tasks and modules that a test writes down for itself."""
