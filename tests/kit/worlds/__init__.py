"""Small worlds with the modules that drive them."""
