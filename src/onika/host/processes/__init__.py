"""Processes of the runtime as such: how they begin, are spoken to, get real time and print."""
