"""The running system follows what documents say, and documents learn what it does."""
