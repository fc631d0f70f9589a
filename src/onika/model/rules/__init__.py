"""The rules of both levels; each answers with all its reasons."""
