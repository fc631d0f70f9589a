"""Open, save, close, undo and recover what comes from files."""
