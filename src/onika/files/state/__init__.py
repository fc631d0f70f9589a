"""What a user of this machine keeps between programs: where it lies, and that nobody else gets at it."""
