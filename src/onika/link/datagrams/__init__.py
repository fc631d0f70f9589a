"""What goes beside connections as datagrams of its own: sealed, counted, and never said again."""
