"""First drafts of the descriptions of robots, out of their models (requirement X19)."""
