"""The search path of a command: the site of this user, this folder and this environment."""

import argparse
import os
from pathlib import Path

from onika.cli.language import learn, say
from onika.store.site import Site, open_site
from onika.words.reason import Reason


def site_here(local: list[str]) -> Site:
    """The site: directories named on the command line first, then ONIKA_LOCAL, then what is shipped."""
    site = open_site([Path(directory) for directory in local], os.environ, Path.home())
    learn(site.directories)
    return site


def directory(text: str) -> str:
    """A directory on the command line; raises ArgumentTypeError where there is none."""
    if not Path(text).is_dir():
        raise argparse.ArgumentTypeError(say(Reason.of("cli.directory_expected", text=text)))
    return text
