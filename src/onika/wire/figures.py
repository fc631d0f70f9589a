"""The figures of a run, as its result tells them: of each task, and of each input that was exchanged."""

from msgspec import Struct


class TaskFigures(Struct, frozen=True):
    """A task's figures over the run."""

    subsystem: str
    task: str
    rtpu: str
    hz: float
    cycles: int
    missed: int
    mean_us: float
    most_us: float


class VariableSteps(Struct, frozen=True):
    """The steps of an input of a hardware task at the reconfigurations of a run (X04)."""

    subsystem: str
    task: str
    variable: str
    unit: str
    count: int
    """At how many of them it was measured."""
    index: int
    """The element with the largest step, and when that was."""
    step: float
    given: float
    limit: float
    at_s: float
    blended: int = 0
    """How often it was blended."""
    cycles: int = 0
    """Over how many cycles at most."""
    refused: int = 0
    """How often it was too large for that, and the device has held."""
