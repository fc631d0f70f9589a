"""A simulated network with everything that goes wrong in it, and the oracle that watches."""
