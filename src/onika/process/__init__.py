"""Processes that end together: the guard above a program, which leaves nothing of it behind."""
