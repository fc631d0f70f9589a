import pytest

from kit.desk.live_runtime import LiveRuntime
from onika.desk.console.console import Console
from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession
from onika.store.site import open_site
from onika.wire import event

ENDPOINT = event.Item("endpoint", "double", 2, "rad", "where to go", None, (-1.0, -1.0), (1.0, 1.0))
DURATION = event.Item("duration", "double", 1, "s", "how long", (3.0,), (0.1,), None)


class ConsoleFixture:
    """A console over a runtime that is played, and all it says."""

    def __init__(self, home, runtime, **given):
        self.runtime = runtime
        self.lines = []
        self.tones = []
        self._now_s = 0.0
        self.interrupts = 0
        site = open_site([home], {}, home)
        self.session = ConsoleSession(runtime, site, self, self.clock, is_interrupted=self._is_interrupted, **given)
        self.console = Console(self.session)
        self.begun = self.session.begin()

    def clock(self):
        """Every look at the clock takes ten milliseconds."""
        self._now_s += 0.01
        return self._now_s

    def say(self, line, tone=Tone.PLAIN):
        self.lines.append(str(line))
        self.tones.append(tone)

    def does(self, *lines):
        """Carry out lines that must succeed; what they said."""
        start = len(self.lines)
        for line in lines:
            faults = self.console.carry_out(line)
            assert faults == (), f"{line}: {faults}"
            self.session.hear()
        return self.lines[start:]

    def fails(self, line):
        """Carry out a line that must fail; its only fault."""
        (fault,) = self.console.carry_out(line)
        return fault

    def states(self, subsystem="main"):
        return {name: task.state for name, task in self.session.tasks(subsystem).items()}

    def requests_of(self, kind):
        return [message for message in self.runtime.asked if isinstance(message, kind)]

    def _is_interrupted(self):
        self.interrupts -= 1
        return self.interrupts == 0


@pytest.fixture
def sit(tmp_path):
    """Begin a sitting; what is given goes to the runtime that is played, unless there is one already."""

    def begin(runtime=None, **given):
        return ConsoleFixture(tmp_path, runtime or LiveRuntime(**given))

    return begin


@pytest.fixture
def asking(sit):
    """A sitting where jtraj asks for a vector and a scalar with a default."""
    return sit(asks={"jtraj": (ENDPOINT, DURATION)})
