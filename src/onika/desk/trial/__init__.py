"""Trials: runs that are kept as tests, done again and judged (requirement X07)."""
