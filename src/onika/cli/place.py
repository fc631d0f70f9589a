"""Where a command looks for files: the site of this user, this folder and this environment."""

import os
from pathlib import Path

from onika.store.site import Site, open_site


def site_here(local: list[str]) -> Site:
    """The site: directories named on the command line first, then ONIKA_LOCAL, then what is shipped."""
    return open_site([Path(one) for one in local], os.environ, Path.home())
