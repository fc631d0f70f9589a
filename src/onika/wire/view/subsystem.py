"""A subsystem in which an application runs, as it can be looked into (requirements C14, C27, E11)."""

from msgspec import field

from onika.wire.view.document import State
from onika.wire.view.view import View
from onika.words.reason import NOTHING, Reason


class LivingTaskView(View, frozen=True):
    """A task of a running application."""

    state: State
    """In a recording empty: each instant tells it."""
    note: Reason = NOTHING
    """Why it failed, where it is in ERROR and that was told."""
    rtpu: str = ""
    hz: float = 0.0
    """The rate that its file asks for; 0: it has none."""


class SharedVariableView(View, frozen=True):
    """A state variable, and the tasks that share it."""

    is_constant: bool = False
    writers: tuple[str, ...] = ()
    readers: tuple[str, ...] = ()


class SubsystemView(View, frozen=True):
    """What lives in a subsystem for an application."""

    application: str
    tasks: dict[str, LivingTaskView] = field(default_factory=dict)
    variables: dict[str, SharedVariableView] = field(default_factory=dict)
