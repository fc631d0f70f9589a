"""The report of a study: a page with pictures in it, and its figures as CSV (requirements H02, H03)."""
