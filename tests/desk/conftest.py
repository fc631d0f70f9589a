import pytest

from kit.desk.shipped_readings import ShippedReadings
from onika.desk.plan.preparation import prepare_run
from onika.desk.run.outcome import Outcome
from onika.desk.run.running_application import Running
from onika.desk.run.settings import RunSettings
from onika.link.lost import closed
from onika.store.site import open_site
from onika.wire import event, live, request, steer


@pytest.fixture(autouse=True, scope="session")
def shipped_readings():
    """What is shipped is read once, and not by every environment."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("onika.store.base_directory.open_file", ShippedReadings())
        yield


PREPARED = prepare_run("two_arms", open_site([], {}, None))


def _at(message):
    """When it happens; the end of a run says no time, and is ten seconds after its beginning."""
    return getattr(message, "at_s", 10.0)


class HeldRuntime:
    """A runtime with a clock: events happen at their times; a held run stands after each that can be waited for.

    Where the run is not held, `wall` is its time, which each look at the events lets pass by a tenth of a second.
    """

    pid = 4711

    def __init__(self, *events):
        self.coming = sorted(events, key=_at)
        self.requests = []
        self.pending = []
        self.refusals = {}
        self.positions = ()
        self.values = {"LAMP": 1}
        self.now_s = 0.0
        self.is_held = False
        self.is_lost = False

    def wall(self):
        return self.now_s

    def ask(self, message):
        self.requests.append(message)
        reason = self.refusals.get(type(message).__name__)
        if reason is not None:
            return request.Refused(reason)
        match message:
            case request.Begin():
                self.is_held = message.is_held
            case steer.Onward():
                self._onward(message.until_s)
            case steer.Who():
                return steer.Positions(self.positions)
            case live.Read():
                return live.Values({name: self.values[name] for name in message.names}, self.now_s)
            case request.Abort():
                self.pending.append(event.Result(False, message.cause, 0, 4, self.now_s, 0.1, {}, (), ""))
            case request.Snapshot():
                return request.Worlds({"boxes": b"drawn"})
        return request.Done()

    def events(self, timeout_s):
        if self.is_lost:
            raise closed("it is gone")
        if not self.is_held:
            self.now_s += 0.1
            self._pass(self.now_s)
        due, self.pending = self.pending, []
        yield from due

    def black_box(self):
        """Where the last seconds of a run would stand whose runtime has died."""
        return ""

    def printed(self):
        return "it printed this"

    def of(self, *kinds):
        return [message for message in self.requests if isinstance(message, kinds)]

    def _onward(self, until_s):
        limit = 50.0 if until_s is None else until_s
        if self.coming and _at(self.coming[0]) <= limit:
            message = self.coming.pop(0)
            self.now_s = max(self.now_s, _at(message))
            self.pending.append(message)
            if isinstance(message, event.Result):
                return
        else:
            self.now_s = max(self.now_s, limit)
        self.pending.append(event.Stood(self.now_s))

    def _pass(self, until_s):
        while self.coming and _at(self.coming[0]) <= until_s:
            self.pending.append(self.coming.pop(0))


@pytest.fixture
def running():
    """Begin a run of two flows at a runtime that is played; the run and the runtime."""

    def begin(*events, is_held=True, **settings):
        runtime = HeldRuntime(*events)
        given = RunSettings("two_arms", **settings)
        outcome = Outcome("two_arms")
        run = Running(given, PREPARED, PREPARED.plan, runtime, outcome, is_held=is_held, clock=runtime.wall)
        run.begin()
        return run, runtime

    return begin
