"""What is typed at a terminal: keys, lines, and the lines that were typed before."""
