import pytest

from onika.desk.plan.preparation import prepare_run
from onika.desk.run.outcome import Outcome
from onika.desk.run.running_application import Running
from onika.desk.run.settings import RunSettings
from onika.link.lost import closed
from onika.store.site import open_site
from onika.wire import event, live, request, steer

PREPARED = prepare_run("two_arms", open_site([], {}, None))


def _at(one):
    """When it happens; the end of a run says no time, and is ten seconds after its beginning."""
    return getattr(one, "at_s", 10.0)


class HeldRuntime:
    """A runtime with a clock: events happen at their times; a held run stands after each that can be waited for.

    Where the run is not held, `wall` is its time, which each look at the events lets pass by a tenth of a second.
    """

    pid = 4711

    def __init__(self, *events):
        self.coming = sorted(events, key=_at)
        self.asked = []
        self.told = []
        self.refusals = {}
        self.positions = ()
        self.values = {"LAMP": 1}
        self.now_s = 0.0
        self.is_held = False
        self.is_lost = False

    def wall(self):
        return self.now_s

    def ask(self, asked):
        self.asked.append(asked)
        reason = self.refusals.get(type(asked).__name__)
        if reason is not None:
            return request.Refused(reason)
        match asked:
            case request.Begin():
                self.is_held = asked.is_held
            case steer.Onward():
                self._onward(asked.until_s)
            case steer.Who():
                return steer.Positions(self.positions)
            case live.Read():
                return live.Values({name: self.values[name] for name in asked.names}, self.now_s)
            case request.Abort():
                self.told.append(event.Result(False, asked.cause, 0, 4, self.now_s, 0.1, {}, (), ""))
            case request.Snapshot():
                return request.Worlds({"boxes": b"drawn"})
        return request.Done()

    def events(self, timeout_s):
        if self.is_lost:
            raise closed("it is gone")
        if not self.is_held:
            self.now_s += 0.1
            self._pass(self.now_s)
        told, self.told = self.told, []
        yield from told

    def printed(self):
        return "it printed this"

    def of(self, *kinds):
        return [one for one in self.asked if isinstance(one, kinds)]

    def _onward(self, until_s):
        limit = 50.0 if until_s is None else until_s
        if self.coming and _at(self.coming[0]) <= limit:
            one = self.coming.pop(0)
            self.now_s = max(self.now_s, _at(one))
            self.told.append(one)
            if isinstance(one, event.Result):
                return
        else:
            self.now_s = max(self.now_s, limit)
        self.told.append(event.Stood(self.now_s))

    def _pass(self, until_s):
        while self.coming and _at(self.coming[0]) <= until_s:
            self.told.append(self.coming.pop(0))


@pytest.fixture
def running():
    """Begin a run of two flows at a runtime that is played; the run and the runtime."""

    def begin(*events, is_held=True, **settings):
        runtime = HeldRuntime(*events)
        given = RunSettings("two_arms", **settings)
        outcome = Outcome("two_arms")
        one = Running(given, PREPARED, PREPARED.plan, runtime, outcome, is_held=is_held, clock=runtime.wall)
        one.begin()
        return one, runtime

    return begin
