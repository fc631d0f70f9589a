"""Any event, and how it travels."""

import msgspec

from onika.wire.event.action import Began, Done, Met, Moved, Stood
from onika.wire.event.device import Drive, Mishap, Outdated, Stepped, Touched
from onika.wire.event.ending import Recording, Result
from onika.wire.event.explanation import Explained, LastSecondsKept
from onika.wire.event.holder import Company, Edited, Held, Offered, Stopped
from onika.wire.event.slot import ClockSet, SlotEnds
from onika.wire.event.task import Failed, Signalled, TaskState, Warned
from onika.wire.event.unit import Lost, UnitUp
from onika.wire.question import Asked

Event = (
    Began
    | Done
    | TaskState
    | Warned
    | Failed
    | Asked
    | Drive
    | Mishap
    | Moved
    | Met
    | Stepped
    | Explained
    | LastSecondsKept
    | Recording
    | Result
    | Edited
    | Signalled
    | Lost
    | UnitUp
    | Outdated
    | Touched
    | Held
    | Offered
    | Company
    | Stopped
    | Stood
    | SlotEnds
    | ClockSet
)

encode = msgspec.msgpack.Encoder().encode
decode = msgspec.msgpack.Decoder(Event).decode
