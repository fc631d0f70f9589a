"""A running application: a program follows its events and steers it (requirements E07, E11, E13).

    with start(RunSettings("assemble", is_virtual=True), site) as running:
        running.steer("break 3")
        running.wait("paused")
        running.steer("continue")
        print(running.result().completed)

In virtual time the clock stands while the program thinks: it goes on only within `events`, `wait` and `result`. So what
a program does leads to the same run, bit for bit.
"""

from collections import deque
from collections.abc import Callable, Iterator
from time import monotonic
from typing import TYPE_CHECKING

from msgspec import structs

from onika.desk.plan.flow_index import FlowIndex
from onika.desk.plan.preparation import PreparedRun
from onika.desk.run import steering
from onika.desk.run.flow_tracker import FlowTracker
from onika.desk.run.outcome import Outcome
from onika.desk.run.pending_wait import PendingWait
from onika.desk.run.runtime_conversation import RunRuntime
from onika.desk.run.settings import RunSettings
from onika.desk.run.steering import Act, Expectation, PositionQuery, SteeringOrder, SteeringWait
from onika.link.lost import LinkLost
from onika.wire import event, live, request, steer
from onika.wire.plan import Plan
from onika.wire.runtime_standing import Standing
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of

if TYPE_CHECKING:
    from onika.desk.run.recorded_run import RecordedRun

Faults = tuple[Fault, ...]
"""Why something was not done; empty where it was."""

LINE = Place("line")
_LOOK_S = 0.05
_PATIENCE_S = 60.0


class Running:
    """One run, begun or about to be.

    `outcome` says how it ended, and has the faults for which it is refused; then nothing is to be steered.
    """

    def __init__(
        self,
        settings: RunSettings,
        prepared: PreparedRun,
        plan: Plan,
        runtime: RunRuntime,
        outcome: Outcome,
        *,
        is_held: bool,
        recorded: "RecordedRun | None" = None,
        clock: Callable[[], float] = monotonic,
    ) -> None:
        self.prepared = prepared
        self.plan = plan
        self.outcome = outcome
        self.flow_index = FlowIndex.of(plan)
        self.flow_tracker = FlowTracker(self.flow_index)
        self.is_held = is_held
        """In virtual time: whether its clock waits for the one who steers."""
        self.stands = False
        """Whether the clock of a held run stands."""
        self._settings = settings
        self._recorded = recorded
        self._runtime = runtime
        self._clock = clock
        self._began = clock()
        self._stood_s = 0.0
        self._news: deque[event.Event] = deque()

    # -- what is so

    @property
    def pid(self) -> int | None:
        """The process of the runtime, None where it was not launched from here."""
        return self._runtime.pid

    @property
    def is_over(self) -> bool:
        """Whether the run has come to its end, or never began."""
        return self.outcome.result is not None

    @property
    def is_aborted(self) -> bool:
        """Whether it came to another end than its own."""
        return self.outcome.result is not None and not self.outcome.result.completed

    @property
    def now_s(self) -> float:
        """Seconds since the run's start: the run's own where it is held, else those of a clock on the wall."""
        if self.is_held:
            return self._stood_s
        return self._clock() - self._began

    def is_stuck(self) -> bool:
        """Whether no flow goes on by itself: only somebody who steers can help."""
        if not self.flow_tracker.is_stuck or self.flow_tracker.is_asking or self._is_repeating():
            return False
        heard_places = [(spot.state, spot.action) for spot in self.flow_tracker.statuses.values()]
        told_places = {position.subsystem: (position.state, position.action) for position in self.who()}
        # what was heard may be overtaken already by what the last order did
        return not told_places or heard_places == [told_places.get(name) for name in self.flow_tracker.statuses]

    def _is_repeating(self) -> bool:
        """Whether a recorded run has not come yet to the instant from which it goes on by itself."""
        if self._recorded is None:
            return False
        answer = self._runtime.ask(live.Survey())
        return isinstance(answer, Standing) and self._recorded.is_before(answer.now_s)

    def who(self) -> tuple[steer.Position, ...]:
        """Where every flow is, and who waits for whom (X03); none where the runtime does not say."""
        answer = self._runtime.ask(steer.Who())
        if not isinstance(answer, steer.Positions):
            return ()
        self.flow_tracker.place(answer.flows)
        return answer.flows

    def read(self, address: str) -> object:
        """A variable `[SUBSYSTEM/]NAME` as it is now; raises ValueError for one that no task reads or writes."""
        subsystem, name = self.flow_index.home(address)
        answer = self._runtime.ask(live.Read(subsystem, (name,)))
        if not isinstance(answer, live.Values):
            raise ValueError(Reason.of("desk.no_value_of", address=address, given=str(answer)))
        return answer.values[name]

    def sheets(self) -> dict[str, ModuleSheet]:
        """What the modules of its tasks declare, each by the digest of its code."""
        answer = self._runtime.ask(live.Describe(self.plan.code))
        if isinstance(answer, live.Described):
            return answer.sheets
        return {}

    # -- what happens

    def begin(self) -> None:
        """Begin it; where the runtime will not, it is over, with the cause."""
        self._began = self._clock()
        message = self._settings.begin(is_held=self.is_held)
        answer = self._runtime.ask(message if self._recorded is None else self._recorded.begin(message))
        if isinstance(answer, request.Refused):
            self.outcome.result = self._unfinished(answer.reason)  # it has not begun: nobody keeps its last seconds
        elif self.is_held:
            self._onward(0.0)

    def events(self) -> Iterator[event.Event]:
        """What happens, to the end of the run; the result comes last. Raises LinkLost or TimeoutError.

        In a held run the clock stands whenever something is told.
        """
        while not self.is_over:
            self._listen(_LOOK_S)
            if self.is_held and not (self.stands or self.is_over):
                continue
            while self._news:
                yield self._news.popleft()
            self.go_on()
        while self._news:
            yield self._news.popleft()

    def hear(self, timeout_s: float = 0.0) -> Iterator[event.Event]:
        """What has happened since the last call, waiting for the first of it so long."""
        if not self._news and not self.is_over:
            self._listen(timeout_s)
        while self._news:  # one by one: whoever stops listening hears the others next time
            yield self._news.popleft()

    def go_on(self, until_s: float | None = None) -> None:
        """Let the clock of a held run go on, to the next thing that happens or to this time."""
        if self.stands and not self.is_over:
            self._onward(until_s)

    def _listen(self, timeout_s: float) -> None:
        for message in self._runtime.events(timeout_s):
            if isinstance(message, event.Stood):
                self.stands = True
                self._stood_s = message.at_s
                continue
            self.flow_tracker.hear(message)
            self._news.append(message)
            if isinstance(message, event.Result):
                self.outcome.result = message
                return

    def _onward(self, until_s: float | None) -> None:
        self.stands = False
        self._runtime.ask(steer.Onward(until_s))

    def _settle(self) -> None:
        """In a held run: what was asked for is carried out before anything else is."""
        if not self.is_held or self.is_over:
            return
        until = self._clock() + _PATIENCE_S
        while not (self.stands or self.is_over or self.flow_tracker.is_asking):
            self._listen(_LOOK_S)
            if self._clock() > until:
                raise TimeoutError(Reason.of("desk.restless", seconds=_PATIENCE_S))

    # -- what may be done

    def steer(self, line: str, *, at_once: bool = False) -> Faults:
        """Do what a line of steering says (`desk.run.steering`), as in `skip flow0 3`; `wait` and `expect` too.

        at_once    even while the clock of a held run goes on, at whatever time that is
        """
        try:
            act = steering.act(line, self.flow_index)
        except ValueError as wrong:
            return (Fault(LINE, reason_of(wrong), steering.GOES_ON),)
        return self.do(act, at_once=at_once)

    def do(self, act: Act, place: Place = LINE, *, at_once: bool = False) -> Faults:
        """Do it; why not."""
        if not at_once:
            self._settle()
        match act:
            case SteeringOrder():
                return self._order(act, place)
            case PositionQuery():
                self.who()
                return ()
            case Expectation():
                return self._expect(act, place)
            case SteeringWait():
                return self._wait(act, place)

    def wait(self, words: str, within_s: float = steering.USUAL_S) -> Faults:
        """Wait for `began 3`, `done flow0 3`, `paused`, `waiting`, `stopped`, `done` or seconds; a fault if in vain."""
        return self.steer(f"wait {words} within {within_s:g}")

    def answer(self, question: event.Asked, line: str | None) -> None:
        """Answer a task that asks; None ends the run."""
        if self._recorded is not None and self._recorded.is_before(question.at_s):
            return
        self.flow_tracker.is_asking = False
        cause = Reason.of("desk.nobody_answers", task=question.task)
        self._runtime.ask(
            request.Abort(cause) if line is None else request.Reply(question.subsystem, question.task, line)
        )

    def stop(self, cause: Reason) -> None:
        """Every drive holds, and the run ends (law 27)."""
        self._runtime.ask(request.Stop(cause))

    def abort(self, cause: Reason) -> None:
        """End the run: tasks off, drives in hold."""
        self._runtime.ask(request.Abort(cause))

    def result(self) -> event.Result:
        """Let it go on to its end, or end it where only somebody who steers could help; its result.

        Raises LinkLost or TimeoutError.
        """
        while not self.is_over:
            for _ in self.hear(_LOOK_S):
                pass
            if not self.is_over and self.is_stuck():
                self.abort(Reason.of("desk.nobody_goes_on", flows=self.flow_tracker.standing()))
            self.go_on()
        if self.outcome.result is None:
            raise ValueError(Reason.of("desk.no_result"))
        return self.outcome.result

    def _order(self, order: SteeringOrder, place: Place) -> Faults:
        if self.is_over:
            return (Fault(place, Reason.of("desk.run_over"), Reason.of("desk.nothing_done")),)
        self.flow_tracker.steered(order.subsystem, is_skip=order.is_skip)
        answer = self._runtime.ask(order.message)
        if self.is_held and self.stands:
            self._onward(self.now_s)
            self._settle()
        if isinstance(answer, request.Refused):
            return (Fault(place, answer.reason, steering.GOES_ON),)
        return ()

    def _expect(self, act: Expectation, place: Place) -> Faults:
        condition = act.condition
        values = {condition.address: self.read(f"{act.subsystem}/{act.name}")}
        if condition.holds(values):
            return ()
        return (
            Fault(
                place,
                Reason.of("desk.condition_fails", text=condition.text, given=str(condition.value_of(values))),
                Reason.of("desk.not_so"),
            ),
        )

    def _wait(self, act: SteeringWait, place: Place) -> Faults:
        pending_wait = self.pending_wait(act)
        while not pending_wait.is_over:
            if self.flow_tracker.is_asking:
                return (
                    Fault(
                        place, Reason.of("desk.task_asks", moment=str(act.condition)), Reason.of("desk.answer_first")
                    ),
                )
            self.go_on(pending_wait.until_s)
            self._listen(_LOOK_S)
        self._settle()  # its moment is told before its time is
        return pending_wait.faults(place)

    def pending_wait(self, act: SteeringWait) -> PendingWait:
        """A wait that begins now."""
        return PendingWait(self, act)

    def lose(self, cause: Reason) -> None:
        """What the environment knows of a run whose runtime can say nothing any more (E10)."""
        self.outcome.result = structs.replace(self._unfinished(cause), black_box=self._runtime.black_box())

    def _unfinished(self, cause: Reason) -> event.Result:
        """How far it came, as far as it was told."""
        actions = sum(len(flow.actions) for flow in self.plan.flows)
        lasted = (self.now_s, self._clock() - self._began)
        return event.Result(False, cause, self.flow_tracker.done, actions, *lasted, {}, (), "")

    # -- its end

    def close(self) -> None:
        """Judge what was expected of it; a run that still goes on is aborted. Never raises LinkLost."""
        try:
            if not self.is_over:
                self.abort(Reason.of("desk.program_left"))
                until = self._clock() + _PATIENCE_S
                while not self.is_over and self._clock() < until:
                    self._listen(_LOOK_S)
            self._judge()
        except (LinkLost, TimeoutError) as lost:
            if not self.is_over:
                self.lose(reason_of(lost))

    def _judge(self) -> None:
        result = self.outcome.result
        if result is None:
            return
        self.outcome.printed = "" if result.completed else self._runtime.printed()
        self.outcome.expectations = [
            (expectation, expectation.value_of(result.values), expectation.holds(result.values))
            for expectation in self._settings.expectations
        ]
        if self._settings.wants_picture:
            answer = self._runtime.ask(request.Snapshot())
            self.outcome.snapshots = answer.snapshots if isinstance(answer, request.Worlds) else {}
