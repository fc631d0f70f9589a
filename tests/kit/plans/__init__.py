"""Plans and programs for tests, sound ones and planted ones, without any file."""
