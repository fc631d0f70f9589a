"""The test kit: builders, playbooks, fakes, a simulated network. Imported by tests only."""
