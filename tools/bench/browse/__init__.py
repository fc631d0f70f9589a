"""What benchmarks of the page share: the program, a Chromium that measures, a browser without a window."""
