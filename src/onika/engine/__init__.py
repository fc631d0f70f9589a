"""Executes applications: news in, orders out, without clock, link or process."""
