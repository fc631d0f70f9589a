"""Dictionaries and their icons: opened, followed, shown; targets made and taught."""
