"""A configuration that lives, at the page."""
