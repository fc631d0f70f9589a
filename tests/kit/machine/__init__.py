"""Another machine, as far as one machine can play it."""
