"""What the command line says of libraries and sites, line by line."""
