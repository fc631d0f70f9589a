"""The console of a runtime: what is asked of it by hand, in lines, and how its events read (requirement A16, §E.1)."""
