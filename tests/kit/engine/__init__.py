"""What tests of the engine tell it: playbooks, simulated tasks, and the engine once more in its simplest form."""
