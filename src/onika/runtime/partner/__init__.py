"""A program outside Onika with which a task talks."""
