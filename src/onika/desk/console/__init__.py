"""The console: operates a runtime by hand, by lines that are typed, and shows its events (requirement A16, §E.1)."""
