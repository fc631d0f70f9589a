"""Where a button or a line of the log leads: what the page selects and brings into view (X01)."""

from msgspec import Struct


class Destination(Struct, frozen=True, tag_field="t", tag=True):
    """Something that the page can go to."""


class ShowTask(Destination, frozen=True):
    """A task on the canvas."""

    task: str


class ShowPin(Destination, frozen=True):
    """A pin of a task, where its variable is given another name; the task stands on the canvas or in a library."""

    task: str
    pin: str


class ShowLocus(Destination, frozen=True):
    """The dot of a state variable on the canvas."""

    svar: str


class ShowSource(Destination, frozen=True):
    """The source text of a task's module, at a line of it; 0: at its beginning."""

    task: str
    line: int = 0


class ShowAnswer(Destination, frozen=True):
    """The form in which a task is given what it asks for."""

    task: str


class ShowLibraryTask(Destination, frozen=True):
    """A task in its library."""

    task: str


class ShowLibraries(Destination, frozen=True):
    """The panel in which a library is opened."""


class ShowConnect(Destination, frozen=True):
    """The panel in which a configuration is connected with a runtime."""


class ShowSaveAs(Destination, frozen=True):
    """The panel in which a name and a base directory are chosen."""


class ShowStep(Destination, frozen=True):
    """A step of an application."""

    step: int


class ShowFits(Destination, frozen=True):
    """What in the dictionary fits behind a step of a flow; 0 is the start icon."""

    flow: str
    after: int


class ShowValues(Destination, frozen=True):
    """The values of the target at a step."""

    step: int


class ShowLoop(Destination, frozen=True):
    """The loop at a step, to be marked anew."""

    step: int


class ShowConfiguration(Destination, frozen=True):
    """The configuration behind a job."""

    name: str


class ShowOnikon(Destination, frozen=True):
    """An icon in its dictionary."""

    onikon: str


class ShowRecording(Destination, frozen=True):
    """A recorded run, or the last seconds of something; it is opened."""

    path: str


class ShowTarget(Destination, frozen=True):
    """The panel in which a target of a type is made."""

    type: str


AnyShow = (
    ShowTask
    | ShowPin
    | ShowLocus
    | ShowSource
    | ShowAnswer
    | ShowLibraryTask
    | ShowLibraries
    | ShowConnect
    | ShowSaveAs
    | ShowStep
    | ShowFits
    | ShowValues
    | ShowLoop
    | ShowConfiguration
    | ShowOnikon
    | ShowTarget
    | ShowRecording
)
