"""Trials: a run is kept as a test, run again later, and judged (requirement X07)."""
