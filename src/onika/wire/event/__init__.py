"""What a runtime tells while it runs a plan: signals on their way to the user, numbered by the link, never lost.

Times are seconds since the run's start in the runtime's own time.
"""

from onika.wire.event.action import Began as Began, Done as Done, Met as Met, Moved as Moved, Stood as Stood
from onika.wire.event.any_event import Event as Event, decode as decode, encode as encode
from onika.wire.event.device import (
    Drive as Drive,
    Mishap as Mishap,
    Outdated as Outdated,
    Stepped as Stepped,
    Touched as Touched,
)
from onika.wire.event.ending import Recording as Recording, Result as Result
from onika.wire.event.explanation import Course as Course, Explained as Explained, LastSecondsKept as LastSecondsKept
from onika.wire.event.holder import (
    Company as Company,
    Edited as Edited,
    Held as Held,
    Offered as Offered,
    Stopped as Stopped,
)
from onika.wire.event.slot import ClockSet as ClockSet, SlotEnds as SlotEnds
from onika.wire.event.task import (
    Failed as Failed,
    Signalled as Signalled,
    TaskState as TaskState,
    Warned as Warned,
)
from onika.wire.event.unit import Lost as Lost, UnitUp as UnitUp
from onika.wire.question import Asked as Asked, Item as Item
