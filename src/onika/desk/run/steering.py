"""The steering language: parses a line such as `pause 0` into a request to the runtime (requirements E07, E08, E13)."""

from collections.abc import Callable
from dataclasses import dataclass

from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run.wait_condition import WaitCondition
from onika.wire import live, request, steer
from onika.words.condition import Condition
from onika.words.reason import Reason

GOES_ON = Reason.of("desk.run_goes_on")
"""What happens instead of a line that cannot be carried out."""

USUAL_S = 60.0
"""How long is waited where nothing is said."""


@dataclass(frozen=True, slots=True)
class SteeringOrder:
    """Something to ask of the runtime that changes the course."""

    message: request.Request
    subsystem: str = ""
    """The flow that it is for; empty: all."""
    is_skip: bool = False


@dataclass(frozen=True, slots=True)
class PositionQuery:
    """Who is where, and who waits for whom."""


@dataclass(frozen=True, slots=True)
class SteeringWait:
    """Go on at a condition; a fault where it does not come within the seconds."""

    condition: WaitCondition
    within_s: float = USUAL_S


@dataclass(frozen=True, slots=True)
class Expectation:
    """A fault where the condition does not hold now."""

    condition: Condition
    subsystem: str
    name: str


Act = SteeringOrder | PositionQuery | SteeringWait | Expectation


@dataclass(frozen=True, slots=True)
class Verb:
    """One word of steering: how it is written, what it does, and who reads what follows it."""

    usage: str
    purpose: Reason
    read: Callable[[list[str], FlowIndex], Act]


def act(line: str, flow_index: FlowIndex) -> Act:
    """What a line means for these flows; raises ValueError that says what was expected and found."""
    name, *words = line.split() or [""]
    verb = VERBS.get(name)
    if verb is None:
        raise ValueError(Reason.of("desk.steering_word", words=tuple(VERBS), name=name))
    try:
        return verb.read(words, flow_index)
    except _Miswritten:
        raise ValueError(Reason.of("desk.steering_usage", usage=verb.usage, line=line.strip())) from None


class _Miswritten(Exception):
    """A line is not written as its usage says."""


# -- which flow


def _every(words: list[str], flow_index: FlowIndex) -> str:
    """`[FLOW]`; empty means all of them."""
    if len(words) > 1:
        raise _Miswritten
    if words:
        return _named(words[0], flow_index)
    return flow_index.lone


def _one(words: list[str], flow_index: FlowIndex) -> str:
    """`[FLOW]`, which has to be said where there are several."""
    return _every(words, flow_index) or _unsaid(flow_index)


def _with_action(words: list[str], flow_index: FlowIndex) -> tuple[str, int]:
    """`[FLOW] N`: a first word that means a flow is one, if more follows; the name of an action may hold blanks."""
    if not words:
        raise _Miswritten
    flow = flow_index.flow(words[0]) if len(words) > 1 else ""
    rest = " ".join(words[1:] if flow else words)
    flow = flow or flow_index.lone or _unsaid(flow_index)
    return flow, flow_index.action(flow, rest)


def _named(word: str, flow_index: FlowIndex) -> str:
    flow = flow_index.flow(word)
    if not flow:
        raise ValueError(Reason.of("desk.flow_or_number", names=flow_index.subsystems, word=word))
    return flow


def _unsaid(flow_index: FlowIndex) -> str:
    raise ValueError(Reason.of("desk.which_flow", names=flow_index.subsystems))


# -- acts


def _to_all(kind: Callable[[str], request.Request]) -> Callable[[list[str], FlowIndex], Act]:
    def read(words: list[str], flow_index: FlowIndex) -> Act:
        flow = _every(words, flow_index)
        return SteeringOrder(kind(flow), flow)

    return read


def _to_one(kind: Callable[[str], request.Request]) -> Callable[[list[str], FlowIndex], Act]:
    def read(words: list[str], flow_index: FlowIndex) -> Act:
        flow = _one(words, flow_index)
        return SteeringOrder(kind(flow), flow)

    return read


def _next(words: list[str], flow_index: FlowIndex) -> Act:
    flow = _one(words, flow_index)
    return SteeringOrder(steer.Skip(flow), flow, is_skip=True)


def _skip(words: list[str], flow_index: FlowIndex) -> Act:
    flow, action = _with_action(words, flow_index)
    return SteeringOrder(steer.Skip(flow, action), flow, is_skip=True)


def _break(words: list[str], flow_index: FlowIndex) -> Act:
    text = ""
    place = next((place for place, word in enumerate(words) if word.lower() == "if"), None)
    if place is not None:
        condition = Condition.parse(" ".join(words[place + 1 :]))
        flow_index.home(condition.address)
        words, text = words[:place], condition.text
    flow, action = _with_action(words, flow_index)
    return SteeringOrder(steer.Mark(flow, action, True, text), flow)


def _unbreak(words: list[str], flow_index: FlowIndex) -> Act:
    flow, action = _with_action(words, flow_index)
    return SteeringOrder(steer.Mark(flow, action, False), flow)


def _abort(words: list[str], flow_index: FlowIndex) -> Act:
    del flow_index
    return SteeringOrder(request.Abort(Reason.plain(" ".join(words)) or Reason.of("desk.aborted_by_user")))


def _who(words: list[str], flow_index: FlowIndex) -> Act:
    del flow_index
    if words:
        raise _Miswritten
    return PositionQuery()


def _touch(words: list[str], flow_index: FlowIndex) -> Act:
    del flow_index
    if len(words) != 3:
        raise _Miswritten
    try:
        value = float(words[2])
    except ValueError:
        raise ValueError(Reason.of("desk.touch_value", word=words[2])) from None
    return SteeringOrder(live.Touch(words[0], words[1], value))


def _pad(words: list[str], flow_index: FlowIndex) -> Act:
    del flow_index
    if words == ["free"]:
        return SteeringOrder(live.Push((0.0,) * 6, is_held=False))
    if words == ["press"]:
        return SteeringOrder(live.Push((0.0,) * 6, is_held=False, button=True))
    try:
        axes = [float(word) for word in words]
    except ValueError:
        raise _Miswritten from None
    if len(axes) not in (3, 6) or any(not -1.0 <= axis <= 1.0 for axis in axes):
        raise _Miswritten
    x, y, z, rx, ry, rz = (*axes, 0.0, 0.0, 0.0)[:6]
    return SteeringOrder(live.Push((x, y, z, rx, ry, rz), is_held=True))


def _expect(words: list[str], flow_index: FlowIndex) -> Act:
    condition = Condition.parse(" ".join(words))
    return Expectation(condition, *flow_index.home(condition.address))


def _wait(words: list[str], flow_index: FlowIndex) -> Act:
    within_s = USUAL_S
    if len(words) > 2 and words[-2] == "within":
        within_s, words = _seconds(words[-1]), words[:-2]
    if not words:
        raise _Miswritten
    kind, rest = words[0], words[1:]
    if kind in ("began", "done") and _is_action(rest, flow_index):
        flow, action = _with_action(rest, flow_index)
        return SteeringWait(WaitCondition(kind, flow, action), within_s)
    if kind in ("paused", "waiting", "stopped", "done"):
        return SteeringWait(WaitCondition(kind, _every(rest, flow_index)), within_s)
    if kind == "began" or rest:
        raise _Miswritten
    return SteeringWait(WaitCondition("seconds", seconds=_seconds(kind)), within_s)


def _is_action(words: list[str], flow_index: FlowIndex) -> bool:
    """Whether an action is named, and not only a flow: where there is one flow, a lone number is an action."""
    if len(words) != 1:
        return bool(words)
    return words[0] not in flow_index.subsystems and bool(flow_index.lone or not flow_index.flow(words[0]))


def _seconds(word: str) -> float:
    try:
        seconds = float(word)
    except ValueError:
        raise _Miswritten from None
    if not 0.0 <= seconds <= 1e6:
        raise ValueError(Reason.of("desk.seconds_range", word=word))
    return seconds


VERBS: dict[str, Verb] = {
    "pause": Verb("pause [FLOW]", Reason.of("desk.does_pause"), _to_all(steer.Pause)),
    "continue": Verb("continue [FLOW]", Reason.of("desk.does_continue"), _to_all(steer.Resume)),
    "step": Verb("step [FLOW]", Reason.of("desk.does_step"), _to_all(steer.Step)),
    "next": Verb("next [FLOW]", Reason.of("desk.does_next"), _next),
    "skip": Verb("skip [FLOW] N", Reason.of("desk.does_skip"), _skip),
    "pass": Verb("pass [FLOW]", Reason.of("desk.does_pass"), _to_one(steer.Pass)),
    "leave": Verb("leave [FLOW]", Reason.of("desk.does_leave"), _to_one(steer.Leave)),
    "break": Verb("break [FLOW] N [if CONDITION]", Reason.of("desk.does_break"), _break),
    "unbreak": Verb("unbreak [FLOW] N", Reason.of("desk.does_unbreak"), _unbreak),
    "clear": Verb("clear [FLOW]", Reason.of("desk.does_clear"), _to_all(steer.Recover)),
    "abort": Verb("abort [CAUSE]", Reason.of("desk.does_abort"), _abort),
    "who": Verb("who", Reason.of("desk.does_who"), _who),
    "touch": Verb("touch WORLD PART VALUE", Reason.of("desk.does_touch"), _touch),
    "pad": Verb("pad (X Y Z [RX RY RZ] | press | free) [for SECONDS]", Reason.of("desk.does_pad"), _pad),
    "wait": Verb(
        "wait (SECONDS | began|done [FLOW] N | paused|waiting|stopped|done [FLOW]) [within SECONDS]",
        Reason.of("desk.does_wait"),
        _wait,
    ),
    "expect": Verb("expect CONDITION", Reason.of("desk.does_expect"), _expect),
}
"""All words of steering."""
