"""Lessons, puzzles and planted faults in the page, each done as a learner does it."""
