"""Libraries and their tasks, as a page shows them."""

from typing import Literal

from onika.wire.view.view import View
from onika.words.reason import Reason


class PinView(View, frozen=True):
    """A pin of a task icon; `y` lies below the icon's upper edge."""

    name: str
    """The coded name."""
    svar: str
    kind: Literal["INCONST", "OUTCONST", "INVAR", "OUTVAR", "INBOTH", "OUTBOTH"]
    y: int
    shape: str = ""
    """As in `double[6]`; empty until the module's class was read."""
    unit: str = ""
    meaning: str = ""


class ParameterView(View, frozen=True):
    """A parameter of a task's module: what the module declares of it, and its words here."""

    name: str
    words: tuple[str, ...] = ()
    """As the LOCAL line has them, else as the default is; none: the line is missing."""
    shape: str = ""
    """Empty where the module does not declare it, or its class is not read yet."""
    unit: str = ""
    meaning: str = ""
    low: float | None = None
    high: float | None = None
    default: tuple[str, ...] = ()


class TaskView(View, frozen=True):
    """A task of a library, with what was changed of it in this session."""

    name: str
    module: str
    library: str
    order: int
    description: str
    width: int
    height: int
    pins: tuple[PinView, ...]
    type: str = "periodic"
    hz: float | None = None
    file_hz: float | None = None
    object_type: str = ""
    is_trigger: bool = False
    local: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """The lines of its LOCAL block."""
    parameters: tuple[ParameterView, ...] = ()
    """Those that its module declares, in their order, then the other lines of its LOCAL block."""
    is_changed: bool = False
    """Whether it is no longer as its file says."""
    path: str = ""
    code: str = ""
    """The path of its module's code; empty: there is none."""
    file: str = ""
    """Of a task that is otherwise in a configuration than in the library: its name there."""


class LibraryView(View, frozen=True):
    """An open library."""

    name: str
    path: str
    order: int
    tasks: int
    faults: tuple[Reason, ...] = ()
    arranged: tuple[str, ...] = ()
    """Its tasks in the order in which a user has put them; those that are not named come behind (D24)."""
    is_shipped: bool = False
    """Whether it comes with Onika; what a user makes is saved elsewhere."""
