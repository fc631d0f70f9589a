"""What the command line writes, line by line: of libraries and sites, to programs, and safe for a terminal."""
