"""The start of the loader process: little has to be loaded for it, so that the loader comes up beside its runtime."""

from typing import NamedTuple

from onika.host.processes.child_process import ChildProcess, start
from onika.host.processes.process_socket import ProcessSocket


class LoaderStart(NamedTuple):
    """A loader process that was started: the runtime's end of its socket, and the process."""

    post: ProcessSocket
    process: ChildProcess

    def end(self) -> None:
        """End the process."""
        self.post.close()
        self.process.kill()
        self.process.wait()


def start_loader(*, stays_inside: bool = False, is_confined: bool = False) -> LoaderStart:
    """Start one; with `stays_inside` what it executes reaches nothing outside. Raises OSError.

    One that is confined is for modules of others, which may compute and nothing else (requirement X16).
    """
    ours, theirs = ProcessSocket.pair()
    arguments = (*(("--stays-inside",) if stays_inside else ()), *(("--confined",) if is_confined else ()))
    return LoaderStart(ours, start("onika.host.loading.loader", theirs, arguments, own_group=True))
