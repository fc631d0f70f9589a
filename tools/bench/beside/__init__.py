"""Benchmarks of Onika beside its peers: `python -m beside` measures, prints and writes the page."""
