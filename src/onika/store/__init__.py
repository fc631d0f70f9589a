"""Base directories, libraries and dictionaries: where files live."""
