"""Execution: tables, tasks, executives, clocks. Knows no process, thread or socket."""
