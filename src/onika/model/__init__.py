"""What Onika is, as immutable values, and its rules. Knows no file, process or network."""
