"""Everything that is open, as values; nothing here acts."""
