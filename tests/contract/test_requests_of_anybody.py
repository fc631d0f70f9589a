"""Whatever a session sends, a runtime lives, answers, and moves nothing that was not asked for; see `message_fuzz`."""

from dataclasses import dataclass, field
from typing import get_args

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.wire.message_fuzz import MessageFuzz
from kit.wire.request_crowd import honest_requests, names_of
from kit.worlds.rail_world import rail_tasks
from onika.host.sessions.request_decoder import decode
from onika.wire import event, holding, live, request
from onika.wire.plan import Again, Choose, Do, Fork, Halt, Join, Jump, Meet, Plan, Rest, Unless
from onika.wire.runtime_standing import Standing

_SLICE_NS = 400_000
_SESSION = 60
"""Requests of one session, before the next one comes."""
_LIFE = 400
"""Requests to one runtime, before a new one is begun: what was done to it last does not hide what comes."""

PROGRAMS = (
    (Do(0), Choose((0, 2), ("X[0] > 0.5",)), Do(1), Rest(1), Again("again", 0, "X[0] < 3"), Halt()),
    (Do(0), Unless("while", 4), Do(1), Jump(0, "while"), Meet("tag"), Rest(-1), Halt()),
)


def _plans() -> list[Plan]:
    moves = [action("mass", "servo", arguments="1.0"), action("mass", "servo", arguments="2.0")]
    straight = rail_tasks().plan(moves)
    (flow,) = straight.flows
    programmed = [replace(straight, flows=(replace(flow, program=program),)) for program in PROGRAMS]
    outer = replace(flow, program=(Do(0), Fork(((1, 0),)), Join((1,)), Do(1), Halt()))
    inner = replace(flow, subsystem="flow0.0", tasks=(), actions=(), program=(Halt(),), parent=0)
    return [straight, *programmed, replace(straight, flows=(outer, inner))]


@dataclass
class _Crowd:
    """Sessions that come and go at one runtime and ask whatever comes to their minds."""

    seed: int
    client: DirectClient = field(default_factory=DirectClient)
    refused: int = 0
    carried_out: int = 0

    def __post_init__(self) -> None:
        plans = _plans()
        self.honest = honest_requests(plans, ("mass", "servo"))
        names = names_of(plans[0], "yard")
        self.fuzz = MessageFuzz(get_args(request.Request), request.encode, self.seed, names)

    def ask(self, number: int) -> None:
        """One message, and a moment for the runtime."""
        if number % _LIFE == 0:
            self.client = DirectClient()
        session = f"session {number // _SESSION}"
        if number % _SESSION == 0:
            self.client.server.gone.append(f"session {number // _SESSION - 1}")
            self.client.ask(live.Reset(), session)
        random = self.fuzz.random
        body = request.encode(random.choice(self.honest)) if number % 4 == 0 else self.fuzz.body(self.honest)
        try:
            message = decode(body)
        except ValueError:
            self.refused += 1
            return
        if self._ends_the_tale(message):
            return
        self.client.send(message, session)
        self.carried_out += 1
        if self.client.program.renewal is not None:
            self.client.go_on_renewed()
        for _ in range(2):
            self.client.program.advance(_SLICE_NS)

    def _ends_the_tale(self, message: request.Request) -> bool:
        """What would only make a long test of nothing: an end, a long wait, most stops; and what writes files."""
        match message:
            case request.Quit():
                return True
            case live.Advance():
                return not message.seconds < 1.0
            case request.Begin():
                return bool(message.record)
            case live.Record():
                return bool(message.path)
            case request.Stop() | holding.OnlyWatch():
                return self.fuzz.random.random() < 0.9
        return False

    def check(self) -> None:
        """The runtime still answers, and no number that is none came to its drive."""
        self.client.server.gone.append("session 0")
        assert isinstance(self.client.ask(live.Survey(), "the last"), Standing)
        causes = [told.cause for told in self.client.server.events if isinstance(told, event.Drive)]
        assert all("no number" not in str(cause) for cause in causes)


def crowd_asks(seed: int, count: int) -> _Crowd:
    crowd = _Crowd(seed)
    for number in range(count):
        crowd.ask(number)
    crowd.check()
    return crowd


@pytest.mark.parametrize("seed", [1, 2])
def test_no_request_ends_a_runtime(seed):  # R-F01
    crowd = crowd_asks(seed, 2_500)
    assert min(crowd.refused, crowd.carried_out) > 500


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3, 23))
def test_no_request_ends_a_runtime_in_a_long_time(seed):  # R-F01
    crowd_asks(seed, 25_000)
