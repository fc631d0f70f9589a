"""What authors of modules test with: a bench for one module, a device on it, an outside partner (guide 6)."""
