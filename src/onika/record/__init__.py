"""Recordings of runs as MCAP files: the runtime writes them, the environment reads them (law 29)."""
