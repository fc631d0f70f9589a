"""Which sites there are: signed cards, places where they are found, and whom the user knows already (F06)."""
