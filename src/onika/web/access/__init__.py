"""Who may come to the page, and what each may do there."""
