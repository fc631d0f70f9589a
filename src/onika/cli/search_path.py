"""The search path of a command: the site of this user, this folder and this environment."""

import argparse
import getpass
import os
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from onika.cli.language import learn, say
from onika.files.state.state_directory import state_directory
from onika.store.remote.credential import Credential
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.library_fetcher import LibraryFetcher
from onika.store.remote.object_cache import ObjectCache, cache_directory
from onika.store.site import Site, open_site
from onika.words.reason import Reason


def site_here(local: list[str]) -> Site:
    """The site: directories named on the command line first, then ONIKA_LOCAL, then what is shipped.

    What a program needs of libraries of others is fetched when it is read.
    """
    site = open_site([Path(directory) for directory in local], os.environ, Path.home())
    learn(site.directories)
    if not site.checkouts:
        return site
    return replace(site, fetcher=LibraryFetcher(site.checkouts, access_here()))


def access_here() -> LibraryAccess:
    """The way to libraries of others from here; who sits at a terminal is asked for passwords."""
    cache = ObjectCache(cache_directory(os.environ))
    return LibraryAccess(cache, state_directory(os.environ), _password if sys.stdin.isatty() else None)


def _password(host: str, why: Reason) -> Credential | None:
    """What the user types, a token where no name; nothing is none. It is kept in memory for this command only."""
    print(say(why), file=sys.stderr)
    user = input(say(Reason.of("cli.library_user", host=host)))
    secret = getpass.getpass(say(Reason.of("cli.library_password" if user else "cli.library_token")))
    return Credential(secret, user) if secret else None


def add_dictionaries(parser: argparse.ArgumentParser) -> None:
    """The dictionaries with which a page begins."""
    parser.add_argument(
        "--dictionary", action="append", default=[], metavar="NAME", help=say(Reason.of("cli.page_dictionary"))
    )


def chosen_dictionaries(site: Site, names: Sequence[str]) -> tuple[Path, ...] | Reason:
    """The base directories of dictionaries that are named as these are; what is there instead of a name that is not."""
    if not names:
        return ()
    there = {base.path.name: base.path for base in reversed(site.directories) if base.onikons}
    unknown = next((name for name in names if name not in there), None)
    if unknown is not None:
        return Reason.of("cli.no_dictionary", names=tuple(sorted(there)), found=unknown)
    return tuple(there[name] for name in dict.fromkeys(names))
