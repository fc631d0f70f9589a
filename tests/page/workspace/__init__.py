"""The upper level at the page: pictures in flows, dictionaries, and what is made of both."""
