"""The settings of a run: the application, real or virtual time, what is expected, and what to do on an error."""

from dataclasses import dataclass
from pathlib import Path

from onika.model.redirect import Redirect
from onika.wire import request
from onika.words.condition import Condition


@dataclass(frozen=True, slots=True)
class RuntimeLocation:
    """A runtime that somebody else started: its address, a token (empty: see `connect`), certificates to trust."""

    url: str
    token: str = ""
    ca: Path | None = None


@dataclass(frozen=True, slots=True)
class RecordingSource:
    """Where a run is taken from: a recording, and the instant up to which it is repeated (None: to its end)."""

    path: Path
    at_s: float | None = None


@dataclass(frozen=True, slots=True)
class RunSettings:
    """What a run is to be."""

    name: str
    is_virtual: bool = False
    expectations: tuple[Condition, ...] = ()
    settle_s: float = 0.5
    seed: int = 0
    answers: tuple[tuple[str, str, str], ...] = ()
    """Task, name of an input, values."""
    may_ask: bool = False
    wants_picture: bool = False
    with_fifo: bool = True
    has_black_box: bool = True
    """Whether a runtime that is launched here keeps the last seconds of a run that ends badly."""
    elsewhere: RuntimeLocation | None = None
    """The runtime to run on; else one is launched here."""
    places: tuple[tuple[str, RuntimeLocation], ...] = ()
    """Where each flow runs, where they run on several runtimes: its name, and the runtime."""
    scale: float | None = None
    """In virtual time: how many times as fast as wall time it passes; None: as fast as it goes."""
    subsystems: tuple[str, ...] = ()
    """Names for the flows' subsystems in place of flow0, flow1 …"""
    on_loss: str = "stop"
    """What becomes of the run when this program is gone: `stop`, `finish` the current actions and pause, `run` on."""
    on_error: str = "abort"
    """When a task that is not passive fails: `abort`, or `wait` until somebody clears it, skips or aborts."""
    redirects: tuple[Redirect, ...] = ()
    """The tasks that stand for others; the application's file stays as it is."""
    script: Path | None = None
    """A file of lines that steer the run (`desk.run.steering_script`)."""

    shake: int | None = None
    """In virtual time: a seed from which the things of the worlds are put a little elsewhere."""

    values: tuple[tuple[str, float], ...] = ()
    """Numbers of tasks that are otherwise than in their files: `TASK.NAME` or `TASK.NAME[ELEMENT]`, and the value."""

    record: Path | None = None
    """The file of a recording to be made."""
    source: RecordingSource | None = None
    """A recording that is repeated up to an instant; its application, seed and answers count."""

    def begin(self, *, is_held: bool) -> request.Begin:
        """What a runtime is asked.

        is_held    in virtual time: whether the clock waits for whoever steers
        """
        return request.Begin(
            watch=tuple(dict.fromkeys(expectation.address for expectation in self.expectations)),
            settle_s=self.settle_s,
            seed=self.seed,
            answers=self.answers,
            may_ask=self.may_ask,
            on_loss=self.on_loss,
            on_error=self.on_error,
            is_held=is_held,
            record="" if self.record is None else str(self.record.absolute()),
        )
