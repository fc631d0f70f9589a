"""Programs of ours as processes: begun, read, and what they leave behind."""
