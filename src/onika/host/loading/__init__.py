"""What is learnt of module code and of plans before anything lives."""
