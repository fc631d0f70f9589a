"""Acts on recorded runs that are looked at."""
