"""Logs of subjects that never were, for tests of studies."""
