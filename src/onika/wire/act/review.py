"""What a user does with recorded runs: look at one, scrub it, compare it, go on from it, keep a run as a test."""

from onika.wire.act.act import Act


class OpenRecording(Act, frozen=True):
    """Look at a recorded run (X05); another one that was looked at is put away."""

    path: str


class CloseRecording(Act, frozen=True):
    """Put the recording away; what runs now is shown again."""


class Recordings(Act, frozen=True):
    """Which recordings there are; the value is a `view.RecordingsView`."""


class Glance(Act, frozen=True):
    """What the recorded run was like at an instant; the value is a `view.InstantView`."""

    at_s: float
    of_other: bool = False
    """Of the run that it is compared with."""


class RecordedScene(Act, frozen=True):
    """What a world of the recorded run consisted of; replied with it as `Scene` is."""

    world: str
    at_s: float = 0.0
    of_other: bool = False


class Course(Act, frozen=True):
    """A variable `SUBSYSTEM/NAME` over a stretch of the recorded run; the value is a tuple of `view.StretchView`."""

    variable: str
    begin_s: float
    end_s: float
    points: int = 800
    of_other: bool = False


class CompareWith(Act, frozen=True):
    """Show another recorded run beside the one that is looked at, with their first difference; empty: no more."""

    path: str
    tolerance: float | None = None
    """How far values may lie apart; None, as for those below: as runs of their kind do."""
    part: float | None = None
    """And by which part of themselves."""
    time_s: float | None = None
    """How far times may lie apart."""


class ShareRecording(Act, frozen=True):
    """Make a file of the recorded run that is looked at, which plays by itself (X21); gives a `view.SharedFileView`."""


class Continue(Act, frozen=True):
    """Go on from an instant of the recorded run in the simulator: the same run up to there, then as it is steered."""

    at_s: float
    confirmed: bool = False
    """Whether the runtime of this environment may end for it, with all that lives there."""


class KeepTest(Act, frozen=True):
    """Keep a run of an application as a test (X07): it is carried out in simulators aside, five times."""

    doc: str
    path: str = ""
    """A file, or a name in the folder of tests beside the application; empty: the application's own name there."""
    expects: tuple[str, ...] = ()
    """What must hold at the end: `LAMP == 1`."""
    confirmed: bool = False
    """Whether a test of that name may be replaced."""
    saves_unsaved: bool = False
    """Whether what it uses and was changed here is saved first: a test does what files say."""
