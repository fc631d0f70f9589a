"""How the environment gets hold of a runtime: started here as a child process, or reached at an address."""

from collections.abc import Sequence
from contextlib import AbstractContextManager

from onika.desk.environment.outcome.outcome import Simulator
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.runtime_conversation import RuntimeConversation

_AS_WALL_TIME = ("--scale", "1")
"""A simulator is looked at by a person, so its time passes as on the wall."""


class RuntimeLauncher:
    """Starts runtimes with these units and options, where no address is given.

    rtpus       the processing units
    options     more words for the runtime program, as `--scale 4`
    """

    def __init__(
        self,
        rtpus: Sequence[str] = ("rt0",),
        *,
        is_virtual: bool = False,
        with_fifo: bool = True,
        options: Sequence[str] = (),
        has_black_box: bool = True,
    ) -> None:
        self._rtpus = tuple(rtpus)
        self._is_virtual = is_virtual
        self._with_fifo = with_fifo
        self._options = tuple(options)
        self._has_black_box = has_black_box

    def __call__(
        self, url: str, token: str, simulator: Simulator | None = None
    ) -> AbstractContextManager[RuntimeConversation]:
        """A runtime; raises ValueError for what is no address, LinkLost where no token is to be had."""
        if url:
            from onika.desk.run.remote_runtime import (
                connect,  # within: it brings along all that speaks to other machines
            )

            return connect(url, token)
        if simulator is not None:
            options = (*_AS_WALL_TIME, *simulator.options)
            return LaunchedRuntime(simulator.rtpus, True, False, options, self._has_black_box)
        return LaunchedRuntime(self._rtpus, self._is_virtual, self._with_fifo, self._options, self._has_black_box)
