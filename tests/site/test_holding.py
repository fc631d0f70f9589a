"""One holder, with real programs: who is silent loses what he holds, what he drove holds, and it is written down."""

import os
import re
import select
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic

import pytest

from onika.desk.run.remote_runtime import connect
from onika.files import trail
from onika.wire import event, holding, live, request
from onika.words.reason import Reason

pytestmark = pytest.mark.site

SCRIPT = """
config jmoveC @home
echo it moves
wait 7
on pd
"""


@pytest.fixture
def there(tmp_path):
    """A runtime in wall time that listens, its address, and where its state lies."""
    environment = os.environ | {"XDG_STATE_HOME": str(tmp_path)}
    environment.pop("ONIKA_TOKEN", None)
    # In real time where that is granted: a device that is late would end its task before its holder is frozen.
    words = [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment) as process:
        match = re.search(r"listening on (\S+), token in (.*)$", process.stdout.readline())
        place = There(match[1], Path(match[2]).read_text().strip(), tmp_path, environment)
        yield place
        for console in place.consoles:
            console.kill()
            console.wait(20)
            console.stdout.close()
        process.terminate()
        assert process.wait(20) == 0
    head = trail.read([tmp_path / "onika" / "audit" / "audit.log"])
    assert head.faults == []
    assert head.records[-1]["what"] == "the runtime ends"


class There:
    def __init__(self, url, token, state, environment):
        self.url, self.token, self.environment = url, token, environment
        self.audit = state / "onika" / "audit" / "audit.log"
        self.consoles = []

    def connect(self):
        return connect(self.url, self.token)

    def console(self, script):
        return self.program("console", self.url, "--script", script, "--no-console")

    def program(self, *words):
        onika = Path(sys.executable).with_name("onika")
        started = subprocess.Popen(
            [onika, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=self.environment
        )
        self.consoles.append(started)
        return started

    def records(self, what):
        return [record for record in trail.read([self.audit]).records if record["what"] == what]


def wait_for(runtime, kind, when=lambda _one: True, seconds=30.0):
    return wait_for_all(runtime, (lambda message: isinstance(message, kind) and when(message),), seconds)[0]


def wait_for_all(runtime, wanted, seconds=30.0):
    """The first message for each wish, in whatever order they come; several may come at one time."""
    found = [None] * len(wanted)
    until = monotonic() + seconds
    while None in found:
        assert monotonic() < until, f"found only {found}"
        for message in runtime.events(0.5):
            for number, is_wanted in enumerate(wanted):
                if found[number] is None and is_wanted(message):
                    found[number] = message
    return found


def is_freed(message):
    return isinstance(message, event.Held) and not message.holder


def is_at_rest(message):
    return isinstance(message, event.Drive) and message.state == "HELD" and "arm" in message.device


def beaten(watcher, lease_s=0.25, seconds=30.0):
    """Wait until datagrams of everybody come through; before, TCP alone tells who lives."""
    until = monotonic() + seconds
    while any(session.lease_s != lease_s for session in watcher.ask(holding.Sessions()).sessions):
        assert monotonic() < until, "no datagram came"
        list(watcher.events(0.05))


def rest(process, watcher):
    """Everything it says to its end; the watcher goes on beating meanwhile."""
    output, line = "", "begin"
    while line:
        list(watcher.events(0.0))
        if select.select([process.stdout], [], [], 0.1)[0]:
            line = process.stdout.readline()
            output += line
    process.stdout.close()
    return output


def test_what_a_frozen_holder_drives_holds_and_he_commands_nothing_when_he_thaws(there, tmp_path):  # R-X12, F7
    (tmp_path / "script").write_text(SCRIPT)
    with there.connect() as watcher:
        watcher.ask(live.Attend(("*",)))
        console = there.console(tmp_path / "script")
        wait_for(watcher, event.Drive, lambda drive: drive.state == "DRIVEN")
        assert "held by" in str(watcher.ask(live.Take("main")).reason)
        beaten(watcher)
        console.send_signal(signal.SIGSTOP)
        freed, held = wait_for_all(watcher, (is_freed, is_at_rest))
        silent_s = float(re.search(r"silent for ([0-9.]+) s", str(freed.cause))[1])
        assert 0.25 <= silent_s < 0.75  # its beats come as datagrams
        assert held.last_command_ns <= held.at_ns
        assert {task.state for subsystem in watcher.ask(live.Survey()).subsystems for task in subsystem.tasks} == {
            "OFF"
        }
        console.send_signal(signal.SIGCONT)
        output = rest(console, watcher)
        assert console.wait(30) == 1, output
        assert "was not heard for too long" in output
        assert watcher.ask(live.Take("main")) == request.Done()
    refused = [record for record in there.records("Change") if "not heard" in record.get("result", "")]
    assert refused and refused[0]["address"] == "127.0.0.1"
    assert any("silent for" in record.get("result", "") for record in there.records("held"))
    assert there.token not in there.audit.read_text()


def test_whoever_runs_an_application_and_was_frozen_hears_when_he_thaws_that_it_has_ended(there):  # R-X12, R-E14
    with there.connect() as watcher:
        watcher.ask(live.Attend(("*",)))
        run = there.program("run", "go_home", "--runtime", there.url)
        wait_for(watcher, event.Drive, lambda drive: drive.state == "DRIVEN")
        beaten(watcher)
        run.send_signal(signal.SIGSTOP)
        assert not wait_for(watcher, event.Result).completed
        run.send_signal(signal.SIGCONT)
        output = rest(run, watcher)
        assert run.wait(30) == 1, output
        assert re.search(r"go_home: aborted, 0 of 1 actions.*\n.*has been silent for", output), output


def test_of_two_real_sessions_one_writes_and_hands_it_to_the_other(there):  # R-X12
    with there.connect() as first, there.connect() as two:
        me, other = (runtime.ask(holding.Sessions()).you for runtime in (first, two))
        assert me != other
        two.ask(live.Attend(("*",)))
        assert first.ask(live.Take("s0")) == request.Done()
        assert "held by" in str(two.ask(live.Take("s0")).reason)
        assert first.ask(holding.Hand("s0", other)) == request.Done()
        assert wait_for(two, event.Offered).to == other
        assert two.ask(live.Take("s0")) == request.Done()
        assert "only its holder" in str(first.ask(holding.Hand("s0", other)).reason)
        assert two.ask(request.Stop(Reason.plain("seen enough"))) == request.Done()
    assert [record.get("who") for record in there.records("held")][:2] == [me, other]
    assert there.records("Stop")[0]["role"] == "owner"
