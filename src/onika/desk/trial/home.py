"""Where test files lie: in a folder beside the applications of a base directory (requirement X07)."""

from pathlib import Path

from onika.store.site import Site

FOLDER = "tests"
"""Where tests lie: beside `appl/` in a base directory."""


def home_of(path: Path, site: Site) -> Site:
    """The site as a test sees it: the base directory in whose `tests` folder it lies comes first."""
    folder = path.absolute().parent
    own = folder.parent
    if folder.name == FOLDER and (own / "appl").is_dir():
        return site.at(own)
    return site
