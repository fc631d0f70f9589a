"""Acts on icons: in applications and in dictionaries."""
