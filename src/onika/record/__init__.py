"""What a recording of a run holds, as an MCAP file: written by the runtime, read by the environment (law 29)."""
