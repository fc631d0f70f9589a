"""Starts a runtime: what its processes share is loaded first, then the rest while its loader comes up."""

import argparse
import importlib
import os
import secrets
import sys

from onika.host.loading.loader_start import start_loader
from onika.host.processes.child_process import serve_forks
from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.preloaded_libraries import preload
from onika.host.runtime_options import followed, options
from onika.link.child.launcher import die_with_parent
from onika.runtime.partner.address import OWN_NAME
from onika.words.own_language import own_language
from onika.words.reason import in_language
from onika.words.system_error import is_used_up, system_reason

_FORECAST_NICE = 19
"""A forecast takes only time that nobody else wants."""

_SHARED = ("onika.host.loading.loader", "onika.host.units.device_server", "onika.host.recording.black_box_process")
"""What the processes of a runtime need is loaded with these, once for all."""


def main(words: list[str]) -> None:
    """The process; where the system has nothing more to give, it ends with the reason."""
    given = options(words)
    if given.parent is not None:
        die_with_parent(given.parent)
    open_output_pipes()
    try:
        _begin(given, words)
    except OSError as refused:
        if not is_used_up(refused):
            raise
        sys.stderr.write(f"{in_language(system_reason(refused), own_language())}\n")
        raise SystemExit(2) from None


def _begin(given: argparse.Namespace, words: list[str]) -> None:
    os.environ[OWN_NAME] = secrets.token_hex(8)  # its processes inherit it, and no other runtime has it
    if given.forecast:
        os.nice(_FORECAST_NICE)
    for name in _SHARED:
        importlib.import_module(name)
    fork_server = serve_forks()
    loader_start = start_loader(stays_inside=given.forecast)
    if fork_server is not None and not given.virtual:  # in virtual time there are no units
        fork_server.preload()
    try:
        from onika.host.runtime_process import run  # within: the loader comes up meanwhile

        if given.options_fd is not None:
            preload()
            given = followed(words, given.options_fd)
    except BaseException:
        loader_start.end()
        raise
    run(given, loader_start)


if __name__ == "__main__":
    main(sys.argv[1:])
