"""Sandboxes as processes: begun by the runtime for tasks of others, asked by the units that have these tasks."""
