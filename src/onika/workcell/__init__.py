"""Simulated physical worlds, stepped by a device server or by a virtual clock."""
