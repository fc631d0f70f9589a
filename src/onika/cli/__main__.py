"""`python -m onika.cli`: the command, whatever is on the search path of programs."""

import sys

from onika.cli import main

if __name__ == "__main__":
    sys.exit(main())
