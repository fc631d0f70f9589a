"""Sweeps: one application many times in virtual time, shaken and varied, and what came of it."""
