"""How a run gets on, live or recorded, as values."""
