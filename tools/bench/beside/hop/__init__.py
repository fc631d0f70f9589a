"""One hop of six doubles from one process to another that waits for it."""
