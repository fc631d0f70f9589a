"""What a user does to an open application: icons, holes, branches, marks, flows.

`doc` is its id. Steps are named by their numbers, which they keep while they are open; 0 is the start icon. A flow is
named by its path: `1` is flow 1, `1/17/0` flow 0 of the branch that is step 17 in it. Nothing in an application is
changed while it runs, but for breakpoints.
"""

from onika.wire.act.act import Act

Steps = tuple[int, ...]
Values = tuple[tuple[str, ...], ...]
"""The words of every data item of a target, in the order of its type."""


class NewApplication(Act, frozen=True):
    """Open a blank application of so many flows; with several, parallel or conditional."""

    flows: int = 1
    is_parallel: bool = False


class InsertIcon(Act, frozen=True):
    """Insert an icon of a dictionary behind a step, by Equation (7); replied with the step's number."""

    doc: str
    onikon: str
    flow: str = "0"
    after: int = 0
    first: str = ""
    """An icon that comes before it, such as the job of a target; both are one step."""


class InsertBranch(Act, frozen=True):
    """Insert a branch with so many empty flows behind a step; replied with its number (D13)."""

    doc: str
    flow: str = "0"
    after: int = 0
    flows: int = 2
    conditions: tuple[str, ...] = ()


class SetConditions(Act, frozen=True):
    """Which flow of a branch runs: the first whose condition holds, else the last; without any, what was returned."""

    doc: str
    step: int
    conditions: tuple[str, ...]


class ExchangeIcon(Act, frozen=True):
    """Put an icon of a dictionary where another stands, with its marks."""

    doc: str
    step: int
    onikon: str


class RemoveIcons(Act, frozen=True):
    """Delete steps; holes open or close by Equation (7)."""

    doc: str
    steps: Steps


class MoveIcons(Act, frozen=True):
    """Take steps out and insert them behind another one, as one step."""

    doc: str
    steps: Steps
    flow: str
    after: int
    replaces: int = 0
    """The icon in whose place they come, in place of `after`: a job goes with its targets; 0: none."""


class CopyIcons(Act, frozen=True):
    """Take steps into the buffer; replied with their text, which may travel by mail."""

    doc: str
    steps: Steps


class CutIcons(Act, frozen=True):
    """Take steps into the buffer and delete them."""

    doc: str
    steps: Steps


class PasteIcons(Act, frozen=True):
    """Insert what is in the buffer, or in a text that was copied elsewhere, behind a step; replied with the numbers."""

    doc: str
    flow: str = "0"
    after: int = 0
    text: str = ""


class EditIcon(Act, frozen=True):
    """Change this one instance of an icon (D17); what is None stays as it is. `picture` is its digits."""

    doc: str
    step: int
    description: str | None = None
    values: Values | None = None
    picture: str | None = None


class SetBreakpoint(Act, frozen=True):
    """Pause after these actions, always or where a condition holds; in a run that goes on, too."""

    doc: str
    steps: Steps
    is_set: bool = True
    condition: str = ""


class SetSynchTag(Act, frozen=True):
    """The tag at which an action waits for other flows; empty takes it away."""

    doc: str
    step: int
    tag: str = ""


class SetLoop(Act, frozen=True):
    """Mark two actions of one flow as a loop: the test decides, and goes on at the anchor; replaces tags they had."""

    doc: str
    test: int
    anchor: int
    tag: str = ""
    """Empty: the first that is free."""
    condition: str = ""
    """Empty: the test's return value."""


class RepeatSteps(Act, frozen=True):
    """Have steps of one flow done so many times: a job that counts comes behind them, and decides a loop over them."""

    doc: str
    steps: Steps
    times: int
    description: str = ""
    """What the icon of a number says that no dictionary has."""


class RemoveLoop(Act, frozen=True):
    """Take the loop away that has a tag at this step."""

    doc: str
    step: int


class AddFlow(Act, frozen=True):
    """One more flow, of the application or of the branch that is this step."""

    doc: str
    step: int = 0


class RemoveFlow(Act, frozen=True):
    """Take a flow away, with all that is in it; one stays."""

    doc: str
    flow: str


class SetParallel(Act, frozen=True):
    """Whether the flows of an application run side by side, or one of them is chosen."""

    doc: str
    is_parallel: bool
