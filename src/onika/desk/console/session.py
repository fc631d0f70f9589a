"""A console session: sends requests to the runtime, shows its events, and remembers what later lines need."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Protocol

from onika.desk.console import event_lines
from onika.desk.console.display import ConsoleDisplay, Tone
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run import text_table
from onika.desk.run.text_table import Cell
from onika.store.site import Site
from onika.wire import event, live, request
from onika.wire.figures import VariableSteps
from onika.wire.lack_of_room import without_gap
from onika.wire.runtime_standing import Standing, TaskStanding
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

Faults = tuple[Fault, ...]
"""Why a line was not carried out; empty where it was."""

Clock = Callable[[], float]
"""A clock of the environment that never goes back, in s (`time.monotonic`)."""

TYPED = Place("line")
"""The place of a line that was typed."""

NOTHING_CHANGED = Reason.of("words.nothing_changed")
_LOOK_S = 0.05
_PATIENCE_S = 30.0
_KEPT = 64


class Runtime(Protocol):
    """A runtime, launched or connected to."""

    def ask(self, message: request.Request) -> request.Response:
        """Ask and wait for the response; raises LinkLost or TimeoutError."""
        ...

    def events(self, timeout_s: float) -> Iterator[event.Event]:
        """The events since the last call; raises LinkLost at the end."""
        ...


@dataclass(frozen=True, slots=True)
class WithoutGap:
    """An order, and the tasks that found no gap between the cycles of their unit."""

    order: live.Change | live.Swap
    tasks: tuple[str, ...]


class ConsoleSession:
    """Asks the runtime, hears what it tells and shows it; names without a subsystem mean the chosen one.

    `is_interrupted` says whether there was a Ctrl-C since it was last asked;
    `in_words` makes the words of a reason in the language of whoever reads them.
    """

    def __init__(
        self,
        runtime: Runtime,
        site: Site,
        face: ConsoleDisplay,
        clock: Clock,
        *,
        is_interrupted: Callable[[], bool] = lambda: False,
        in_words: Callable[[Reason], str] = str,
    ) -> None:
        self._runtime = runtime
        self._face = face
        self.site = site
        self.clock = clock
        self.is_interrupted = is_interrupted
        self.in_words = in_words
        self.place = TYPED
        self.in_script = False
        self.subsystem = "main"
        self.questions: dict[tuple[str, str], event.Asked] = {}
        self.running = ""
        """The application that this console runs."""
        self.running_in: frozenset[str] = frozenset()
        """Its subsystems."""
        self.flow_index: FlowIndex | None = None
        """Its flows and their actions."""
        self.is_stopped = False
        self.result: event.Result | None = None
        """How the last run ended."""
        self.steps: dict[tuple[str, str], event.Stepped | VariableSteps] = {}
        """What was told last of steps in the inputs of hardware, by subsystem and variable."""
        self.without_gap: WithoutGap | None = None
        """What was ordered last, where that found no gap between the cycles of a unit."""
        self.ticks: list[Callable[[], None]] = []
        """What is looked at whenever the runtime is listened to: variables watched, files followed."""
        self._in_tick = False
        self._edits: dict[tuple[str, int], event.Edited] = {}
        self._standing: Standing | None = None
        self._applied: frozenset[str] = frozenset()

    def begin(self) -> Faults:
        """Listen to everything, and choose the subsystem that is there, if it is the only one."""
        answer = self.ask(live.Attend(("*",)))
        if isinstance(answer, request.Refused):
            return self.no(Reason.of("console.not_by_hand", reason=answer.reason))
        self.is_stopped = self.standing().is_stopped
        present = [subsystem for subsystem in self.standing().subsystems if not subsystem.application]
        if len(present) == 1:
            self.subsystem = present[0].name
        return ()

    # -- saying

    def say(self, line: Reason, tone: Tone = Tone.PLAIN) -> None:
        """Show one line."""
        self._face.say(line, tone)

    def show(self, lines: list[str]) -> None:
        """Show a table: its head, then its rows."""
        for number, line in enumerate(lines):
            self.say(Reason.plain(line), Tone.PLAIN if number else Tone.HEAD)

    def show_table(self, head: Sequence[Cell], rows: Iterable[Sequence[Cell]]) -> None:
        """Show a table of what is in these columns."""
        self.show(text_table.lines(head, rows, self.in_words))

    def no(self, reason: Reason, instead: Reason = NOTHING_CHANGED) -> Faults:
        """One fault at the place of the present line."""
        return (Fault(self.place, reason, instead),)

    # -- asking

    def ask(self, message: request.Request) -> request.Response:
        """Ask the runtime; raises LinkLost or TimeoutError."""
        return self._runtime.ask(message)

    def order(self, message: request.Request) -> Faults:
        """Have something carried out, to its outcome: what the runtime refuses or finds wrong are faults."""
        answer = self.ask(message)
        match answer:
            case request.Refused():
                return self.no(Reason.of("console.runtime_refused", reason=answer.reason))
            case request.Prepared():
                for note in answer.notes:
                    self.say(Reason.of("console.note", text=note), Tone.NOTE)
                return tuple(text.fault for text in answer.faults)
            case live.Accepted():
                faults = self._outcome(getattr(message, "subsystem", self.subsystem), answer.number)
                return self._with_ways(message, faults)
        return ()

    def standing(self) -> Standing:
        """What there is, asked anew after every change; raises ValueError where the runtime cannot say it."""
        if self._standing is None:
            answer = self.ask(live.Survey())
            if not isinstance(answer, Standing):
                raise ValueError(Reason.of("console.no_standing", given=str(answer)))
            self._standing = answer
            self._applied = frozenset(subsystem.name for subsystem in answer.subsystems if subsystem.application)
        return self._standing

    def look_again(self) -> Standing:
        """What there is now, the time too."""
        self._standing = None
        return self.standing()

    def tasks(self, subsystem: str = "") -> dict[str, TaskStanding]:
        """The living tasks of a subsystem (the chosen one), by name."""
        for standing in self.standing().subsystems:
            if standing.name == (subsystem or self.subsystem):
                return {task.task.name: task for task in standing.tasks if task.state != "KILLED"}
        return {}

    def address(self, text: str) -> tuple[str, str]:
        """Subsystem and name of `[SUBSYSTEM/]NAME`."""
        subsystem, slash, name = text.rpartition("/")
        if slash:
            return (subsystem, name)
        return (self.subsystem, text)

    # -- hearing

    def hear(self, timeout_s: float = 0.0) -> None:
        """Hear and show what the runtime tells, waiting for the first word so long; raises LinkLost at its end."""
        for message in self._runtime.events(timeout_s):
            is_chatter = self._is_chatter(message)
            self._note(message)
            if not is_chatter:
                for line, tone in event_lines.lines(message, self.in_words):
                    self.say(line, tone)
        self._tick()

    def until(self, reached: Callable[[], bool], expected: Reason, within_s: float = _PATIENCE_S) -> Faults:
        """Hear until something is so; a fault where it is not within the seconds, and after Ctrl-C, which stops all."""
        until_s = self.clock() + within_s
        while not reached():
            if self.is_interrupted():
                return self.interrupt()
            if self.clock() >= until_s:
                late = Reason.of("console.not_so_within", expected=expected, seconds=within_s)
                return self.no(late, Reason.of("console.may_still_come"))
            self.hear(min(_LOOK_S, within_s))
        return ()

    def interrupt(self) -> Faults:
        """Ctrl-C: every drive holds (decision 11)."""
        self.ask(request.Stop(Reason.of("desk.stopped_by_user")))
        self.hear()
        return self.no(Reason.of("console.ctrl_c"), Reason.of("console.everything_stopped"))

    def _outcome(self, subsystem: str, number: int) -> Faults:
        """Wait until a change is done or refused, or a task asks, which is for the user to go on with."""
        questions_before = set(self.questions)
        key = (subsystem, number)
        change = Reason.of("console.change")
        faults = self.until(lambda: key in self._edits or bool(set(self.questions) - questions_before), change)
        if faults or key not in self._edits:
            return faults
        cause = self._edits.pop(key).cause
        if cause:
            return self.no(Reason.of("console.change_refused", cause=cause))
        return ()

    def _with_ways(self, message: request.Request, faults: Faults) -> Faults:
        """Where something found no gap between cycles: with the ways in which it can be done again."""
        tasks = tuple(task for fault in faults for task in without_gap(fault.reason))
        self.without_gap = None
        if tasks and isinstance(message, live.Change | live.Swap) and not message.holds:
            self.without_gap = WithoutGap(message, tasks)
            faults = tuple(replace(fault, instead=Reason.of("console.ways_again")) for fault in faults)
        return faults

    def _tick(self) -> None:
        """Each once; what one of them asks for and hears begins none anew."""
        if self._in_tick:
            return
        self._in_tick = True
        try:
            for tick in self.ticks:
                tick()
        finally:
            self._in_tick = False

    def _note(self, message: event.Event) -> None:
        """Remember what later lines need."""
        self._standing = None
        match message:
            case event.Edited():
                self._edits[message.subsystem, message.number] = message
                while len(self._edits) > _KEPT:  # those of other sessions are awaited by nobody here
                    del self._edits[next(iter(self._edits))]
            case event.Asked():
                self.questions[message.subsystem, message.task] = message
            case event.TaskState() if message.state != "ASKING":
                self.questions.pop((message.subsystem, message.task), None)
            case event.Stopped():
                self.is_stopped = message.is_stopped
            case event.Stepped():
                self.steps[message.subsystem, message.variable] = message
            case event.Result():
                self._ended(message)

    def _ended(self, result: event.Result) -> None:
        self.steps |= {(step.subsystem, step.variable): step for step in result.steps}
        if self._is_own(result):
            self.running, self.flow_index = "", None
            self.result = result

    def _is_own(self, result: event.Result) -> bool:
        """Whether it is the end of what this console runs: several applications may run side by side."""
        subsystems = {task.subsystem for task in result.tasks}
        return bool(self.running) and (not subsystems or bool(subsystems & self.running_in))

    def _is_chatter(self, message: event.Event) -> bool:
        """Whether an application's actions tell it already: what its tasks and drives do, unless it is trouble."""
        if isinstance(message, event.Drive):
            return bool(self.running or self._applied) and message.state not in ("TRIPPED", "PRESSED")
        return isinstance(message, event.TaskState) and message.state != "ERROR" and self._is_applied(message.subsystem)

    def _is_applied(self, subsystem: str) -> bool:
        """Whether an application moves the tasks there."""
        return subsystem in self._applied or (bool(self.running) and subsystem != self.subsystem)


def typed_fault(fault: Fault) -> Reason:
    """What is wrong with the line that was just typed, whose place everybody sees."""
    return Reason.of("console.fault", reason=fault.reason, instead=fault.instead)
