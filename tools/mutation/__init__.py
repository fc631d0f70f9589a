"""Mutants of the safety core: small mistakes, planted one by one, each of which a test has to notice (R-X24)."""
