"""What guards a process of the runtime against the module code that it runs (laws 14, 15, 30)."""
