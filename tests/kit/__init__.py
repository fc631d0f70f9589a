"""The kit of the tests: builders of plans and files, fixtures of both programs, fakes, simulators and oracles."""
