"""What if? Faults that could come, put to the tables that act when they come (requirement X24)."""
