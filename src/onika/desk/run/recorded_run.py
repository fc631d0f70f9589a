"""A recorded run that can begin again: the same plan, seed and inputs, up to an instant (requirement X05)."""

from dataclasses import dataclass

from msgspec import structs

from onika.desk.plan.module_code import with_rights_here
from onika.desk.plan.preparation import PreparedRun
from onika.desk.run.settings import RecordingSource
from onika.record import topics
from onika.record.reader import UNREADABLE, Reader, content
from onika.record.run import END, RunRecord
from onika.wire import event, request
from onika.wire.request import Recorded, encode
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_NOT_RUN = Reason.of("words.nothing_run")


@dataclass(frozen=True, slots=True)
class RecordedRun:
    """What is repeated."""

    prepared: PreparedRun
    run: RunRecord
    inputs: tuple[Recorded, ...]
    until_ns: int
    """-1: to its end."""
    hash: str
    """Of the recorded run, where it was virtual and came to its end."""
    is_exact: bool
    """Whether it is the same run, bit for bit; else one of the same plan and inputs in virtual time."""
    cut_s: float | None = None
    """Where the recording ends that was cut short, if it is repeated to its end: what came then, nobody knows."""

    def begin(self, message: request.Begin) -> request.Begin:
        """What a runtime is asked, where this is wanted beside: as it was asked then, and what was asked later."""
        return structs.replace(
            self.run.begin,
            watch=message.watch,
            is_held=message.is_held,
            may_ask=message.may_ask or self.run.begin.may_ask,
            on_loss=message.on_loss,
            record=message.record,
            repeat=self.inputs,
            repeat_until_ns=self.until_ns,
        )

    def is_before(self, at_s: float) -> bool:
        """Whether what is asked at this time is asked by itself, as it was then."""
        return self.until_ns < 0 or round(at_s * 1e9) < self.until_ns

    @property
    def notes(self) -> tuple[Reason, ...]:
        """What the user has to know."""
        notes = []
        if self.cut_s is not None:
            notes.append(Reason.of("desk.repeat_cut_short", seconds=self.cut_s))
        if not self.is_exact:
            notes.append(Reason.of("desk.repeat_approximate"))
        return tuple(notes)


def recorded_run(source: RecordingSource) -> RecordedRun | tuple[Fault, ...]:
    """Read it; why it cannot be repeated."""
    place = Place(str(source.path))
    try:
        reader = Reader(source.path)
        run = RunRecord.read(reader)
    except UNREADABLE as wrong:
        return (Fault(place, Reason.of("desk.no_recording", given=content(wrong)), _NOT_RUN),)
    end = reader.notes.get(END, {})
    last_s = reader.span[1] * 1e-9
    faults = []
    if run.is_by_hand:
        by_hand = Reason.of("desk.held_by_hand")
        faults.append(Fault(place, Reason.of("desk.not_repeatable", given=by_hand), _NOT_RUN))
    elif not run.is_fresh:
        before = Reason.of("desk.other_things_before")
        faults.append(Fault(place, Reason.of("desk.not_first_run", given=before), _NOT_RUN))
    if end.get("outside"):
        tasks = Reason.of("desk.outside_tasks", tasks=end["outside"])
        faults.append(Fault(place, Reason.of("desk.not_repeatable", given=tasks), _NOT_RUN))
    if source.at_s is not None and not 0 <= source.at_s <= last_s:
        faults.append(Fault(place, Reason.of("desk.instant_outside", last_s=last_s, at_s=source.at_s), _NOT_RUN))
    if faults:
        return tuple(faults)
    whole_ns = -1 if reader.is_whole else reader.span[1]
    until_ns = whole_ns if source.at_s is None else round(source.at_s * 1e9)
    prepare = run.prepare
    plan = structs.replace(prepare.plan, code=tuple(map(with_rights_here, prepare.plan.code)))
    prepared = PreparedRun(plan.application, None, plan, prepare.targets, ())
    inputs = tuple(inputs_of(reader, until_ns))
    reader.close()
    cut_s = None if reader.is_whole or source.at_s is not None else last_s
    return RecordedRun(prepared, run, inputs, until_ns, end.get("hash", ""), run.is_virtual, cut_s)


def inputs_of(reader: Reader, until_ns: int = -1) -> list[Recorded]:
    """What was asked of a run, in the order in which it was, up to an instant; -1: all of it."""
    last = (1 << 62) if until_ns < 0 else until_ns
    inputs = []
    for topic in (topics.COMMANDS, topics.ANSWERS):
        for at, body in reader.messages(topic, 0, last + 1):
            wanted = topics.decode_wanted(body)
            inputs.append(Recorded(at, wanted.turn, encode(wanted.request)))
    return sorted(inputs, key=lambda item: (item.at_ns, item.turn))


def events_of(reader: Reader, begin_ns: int = 0, end_ns: int = 1 << 63) -> list[tuple[int, str, event.Event]]:
    """What happened: when, about whom, and what."""
    faults = []
    for at, body in reader.messages(topics.EVENTS, begin_ns, end_ns):
        happened = topics.decode_happened(body)
        faults.append((at, happened.subsystem, happened.event))
    return faults
