"""What a user does to run an application; a question of it is answered by `Answer`, its task as `SUBSYSTEM/TASK`."""

from typing import Literal

from onika.wire.act.act import Act


class Run(Act, frozen=True):
    """Run an application as it is here, on the runtime of this environment, beside others that need other devices.

    Refused with all its faults at once. What must end first, and what has changed and is not saved, is told before.
    """

    doc: str
    confirmed: bool = False
    """Whether tasks that are in the way may be ended (reading 30)."""
    ignores_unsaved: bool = False
    """Whether configurations run as their files say, although they were changed here."""
    passes_breakpoints: bool = False
    saves_unsaved: bool = False
    """Whether configurations that it uses and that were changed here are saved first."""
    is_recorded: bool = False
    """Whether the run is recorded, in a file of its own (X05)."""
    on_loss: Literal["stop", "finish", "run"] = "stop"
    """What becomes of it where this environment is lost: it ends, finishes its actions and pauses, goes on (X12)."""
    units: tuple[tuple[str, str], ...] = ()
    """Tasks that name no processing unit of this runtime, each with the one that the user has chosen (reading 12)."""
    puts_back: bool = False
    """Whether the workcell is first put back to where everything stood at its start (law 18)."""
    ends_former: bool = False
    """Whether its own run is ended first that still goes on, or stands at an error."""
    goes_on: bool = False
    """Whether its flows begin where those of its last run ended, redirected as they are now (decision 76)."""


class Preflight(Act, frozen=True):
    """Look at everything that could keep an application from running, the modules' reach too; nothing moves (X02).

    The faults are then those of the application, each at its step; replied with how many there are.
    """

    doc: str


class ForeseenInstant(Act, frozen=True):
    """How a workcell stands when something happens that is foreseen; the value is a `view.ForeseenInstantView`."""

    doc: str
    number: int
    """As `view.FaultView.instant` has it."""


class WhatIf(Act, frozen=True):
    """What would follow from a fault; nothing is touched (X24). Replied with a `view.ForesightsView`."""

    fault: str = ""
    """Empty: which faults can be asked about."""
    subject: str = ""
    """Whom it concerns."""
    doc: str = ""
    """An application at its first step, which is prepared for that; empty: what is there now."""
    on_loss: Literal["stop", "finish", "run"] = "stop"
    """As the application would be begun."""


class Redirect(Act, frozen=True):
    """Let another task or world stand for one while this application is open; its file stays as it is (E09).

    A world is named with its colon, as in `boxes:`.
    """

    doc: str
    flow: str
    """The subsystem of the flow, `flow0`; empty: every flow."""
    old: str
    new: str
    """Empty: as it was."""


class Seats(Act, frozen=True):
    """Which tasks the flows of an application use, and who could stand for each; the value is a `view.SeatsView`."""

    doc: str


class FindWorlds(Act, frozen=True):
    """Ask the runtime which worlds it has, and which of them are simulated; it is started where there is none (E09)."""

    station: str = ""


class Steer(Act, frozen=True):
    """A line of steering, in the words of `desk.run.steering`: `pause 0`, `skip 1 3`, `abort`."""

    line: str
    doc: str = ""
    """The application whose run is meant; empty: the one that was begun last."""


class SkipTo(Act, frozen=True):
    """Send the flow of a step to it at once; nothing between is carried out (E13)."""

    step: int
    doc: str = ""
    """The application whose run is meant; empty: the one that was begun last."""


class Dismiss(Act, frozen=True):
    """Put away what is shown of a run that is over."""

    doc: str = ""
    """The application whose run is meant; empty: the one that was begun last."""


class PutBack(Act, frozen=True):
    """Everything in the open workcells to where it stood at the start, in the same runtime (law 18).

    Of a workcell that nobody here can move it is told what a person has to put where.
    """

    station: str = ""


class Touch(Act, frozen=True):
    """A hand presses a part of a simulated workcell, such as a panic button, or lets it go."""

    world: str
    part: str
    is_pressed: bool


class StartAnew(Act, frozen=True):
    """End the runtime of this environment with all that lives there, and start it again: the workcell as it was."""

    confirmed: bool = False
