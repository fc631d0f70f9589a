"""The connection between environment and runtime: nothing lost, nothing twice, nothing out of order."""
