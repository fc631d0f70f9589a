"""A world from files as its runtime sees it, and who touches whom in it."""
