"""The environment: what is open, how it is changed, and what every page is shown of it."""
