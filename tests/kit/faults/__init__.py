"""Faults on purpose: planted, foreseen and struck, each held against what then happens."""
