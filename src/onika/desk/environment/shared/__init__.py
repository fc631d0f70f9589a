"""A recorded run as a file that plays by itself: what a page needs of it, and the page around that."""
