"""Who is connected with a runtime, what each may do, and what was done."""
