import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from onika.link.carrier import wait_for
from onika.link.child import launcher
from onika.link.child.launcher import RuntimeStart, launch
from onika.link.connection import Connection
from onika.link.link_terms import CHILD
from onika.link.lost import LinkLost, LossCause
from onika.process import guard

RUNTIME = """
import select, sys, time
from onika.link.link_events import RequestReceived
from onika.link.signal_journal import SignalJournal
from onika.link.child.launcher import die_with_parent, inherit
from onika.link.runtime_port import ServerPort
from onika.link.link_terms import CHILD

words = dict(zip(sys.argv[1::2], sys.argv[2::2]))
die_with_parent(int(words["--parent"]))
port = ServerPort(SignalJournal("child"), terms=CHILD)
port.attach(inherit(int(words["--link-fd"])), time.monotonic_ns())
print("ready", words.get("--name", ""), flush=True)
while port.is_open:
    due_ns = port.due_ns(time.monotonic_ns())
    select.select([port], [port] if port.want_write() else [], [], None if due_ns is None else due_ns / 1e9)
    for news in port.service(time.monotonic_ns()):
        if isinstance(news, RequestReceived):
            port.reply(news.ticket, news.body[::-1], time.monotonic_ns())
sys.exit(7)
"""


def command(tmp_path, text):
    path = tmp_path / "child.py"
    path.write_text(text)
    return (sys.executable, str(path))


def test_a_launched_runtime_answers_and_ends_with_its_connection(tmp_path):  # R-A15
    with launch(["--name", "left"], command(tmp_path, RUNTIME)) as child:
        connection = Connection(child.carrier, time.monotonic_ns, CHILD)
        assert connection.request(b"abc", timeout_s=60) == b"cba"
        assert child.alive()
        connection.close()
        assert child.wait(60) == 7
        assert child.tail() == "ready left\n"
        assert not child.alive()


def test_a_runtime_that_dies_is_noticed_at_once_and_says_why(tmp_path):  # R-F01
    text = "import sys\nsys.exit('no such laboratory')"
    with launch([], command(tmp_path, text)) as child:
        connection = Connection(child.carrier, time.monotonic_ns, CHILD)
        with pytest.raises(LinkLost) as caught:
            connection.open(60)
        assert caught.value.cause is LossCause.CLOSED
        assert child.wait(60) == 1
        assert child.tail() == "no such laboratory\n"


def test_a_runtime_inherits_its_link_and_nothing_else(tmp_path):
    text = """
import os, sys
def is_open(number):
    try:
        os.fstat(int(number))
    except OSError:
        return False
    return True
print(is_open(sys.argv[2]), is_open(sys.argv[5]), sys.stdin.read() == "")
"""
    secret = os.dup2(2, 300, inheritable=True)
    with launch([str(secret)], command(tmp_path, text)) as child:
        assert child.wait(60) == 0
        assert child.tail() == "True False True\n"
    os.close(secret)


def descriptors():
    return len(list(Path("/proc/self/fd").iterdir()))


def test_a_command_that_does_not_exist_is_an_os_error_and_leaves_nothing_open():
    before = descriptors()
    with pytest.raises(FileNotFoundError):
        launch([], ["/no/such/program"])
    assert descriptors() == before


def test_a_runtime_that_is_over_leaves_nothing_open(tmp_path):
    before = descriptors()
    with launch([], command(tmp_path, "pass")) as child:
        child.wait(60)
    assert descriptors() == before


def test_a_runtime_dies_with_the_program_that_launched_it(tmp_path):  # R-X12
    stubborn = """
import os, signal, sys, time
from onika.link.child.launcher import die_with_parent
die_with_parent(int(sys.argv[sys.argv.index("--parent") + 1]))
print(os.getpid(), flush=True)
while True: time.sleep(60)
"""
    parent = f"""
import os, sys
from onika.link.child.launcher import launch
child = launch([], {command(tmp_path, stubborn)!r})
while not child.tail().endswith("\\n"): pass
print(child.tail(), flush=True)
os._exit(0)
"""
    done = subprocess.run([sys.executable, "-c", parent], capture_output=True, check=True, timeout=60)
    pid = int(done.stdout)
    deadline = time.monotonic() + 60
    while is_running(pid):
        assert time.monotonic() < deadline, "the runtime outlived its parent"


def is_running(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except (FileNotFoundError, ProcessLookupError):  # it ended before, or while it was read
        return False


def test_a_child_whose_parent_is_gone_already_ends_at_once():
    text = "from onika.link.child.launcher import die_with_parent\ndie_with_parent(-1)\nprint('alive')"
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, check=False, timeout=60)
    assert (done.returncode, done.stdout) == (1, b"")


def test_the_command_of_a_runtime_is_this_python_with_the_host():
    assert list(launcher.RUNTIME) == [sys.executable, "-m", "onika.host"]


LEAVES = """
import os, sys, time
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        print(os.getpid(), flush=True)
        time.sleep(600)
    os._exit(0)
"""


@pytest.mark.parametrize("end", ["sys.exit(3)", "time.sleep(600)"])
def test_nothing_is_left_of_what_a_runtime_has_started(tmp_path, end):  # R-X12
    with launch([], command(tmp_path, LEAVES + end)) as child:
        while not child.tail().endswith("\n"):
            wait_for([child.carrier], 0.01)
        child.close(grace_s=0.01)
    assert not is_running(int(child.tail()))


def test_nothing_is_left_of_a_runtime_whose_program_is_killed(tmp_path):  # R-X12
    parent = f"""
import os
from onika.link.child.launcher import launch
child = launch([], {command(tmp_path, LEAVES + "time.sleep(600)")!r})
while not child.tail().endswith("\\n"): pass
print(child.pid, child.tail(), flush=True)
os.kill(os.getpid(), 9)
"""
    done = subprocess.run([sys.executable, "-c", parent], capture_output=True, check=False, timeout=60)
    deadline = time.monotonic() + 60
    while any(map(is_running, map(int, done.stdout.split()))):
        assert time.monotonic() < deadline, "what the runtime had started outlived it"


def test_a_runtime_does_not_outlive_its_guard(tmp_path):  # R-X12
    text = (
        "import os, sys, time\nfrom onika.link.child.launcher import die_with_parent\n"
        "die_with_parent(int(sys.argv[4]))\nprint(os.getppid(), flush=True)\ntime.sleep(600)"
    )
    with launch([], command(tmp_path, text)) as child:
        while not child.tail().endswith("\n"):
            wait_for([child.carrier], 0.01)
        os.kill(int(child.tail()), signal.SIGKILL)
        assert child.wait(60) == -signal.SIGKILL
        deadline = time.monotonic() + 60
        while is_running(child.pid):
            assert time.monotonic() < deadline, "the runtime outlived its guard"


def test_a_runtime_may_have_a_group_of_its_own(tmp_path):  # R-X12
    text = "import os\nprint(os.getpgid(0) == os.getpid(), flush=True)"
    with launch([], command(tmp_path, text), has_modules=True) as child:
        child.wait(60)
        assert child.tail() == "True\n"


WAITS = """
import json, os, sys
number = int(sys.argv[sys.argv.index("--options-fd") + 1])
print("up", flush=True)
more = os.fdopen(number).read()
print(sys.argv[-1], json.loads(more) if more else "nothing", flush=True)
"""


def test_arguments_may_follow_while_the_runtime_comes_up(tmp_path):  # R-A15
    before = descriptors()
    start = RuntimeStart(["early"], command(tmp_path, WAITS), has_more=True)
    with start, start.process(["--name", "l\udcff\u00e9"]) as child:
        assert child.wait(60) == 0
        assert child.tail() == "up\nearly ['--name', 'l\\udcff\u00e9']\n"
    assert descriptors() == before


def test_of_a_start_that_nobody_takes_nothing_is_left(tmp_path):  # R-A15, R-X12
    before, mark = descriptors(), tmp_path / "pid"
    text = f"import os, time\nopen({str(mark)!r}, 'w').write(str(os.getpid()))\ntime.sleep(600)"
    with RuntimeStart([], command(tmp_path, text), has_modules=True, has_more=True):
        deadline = time.monotonic() + 60
        while not (mark.exists() and mark.read_text()):
            assert time.monotonic() < deadline
    assert not is_running(int(mark.read_text()))
    assert descriptors() == before


def test_a_runtime_that_ends_before_its_arguments_says_so_itself(tmp_path):  # R-F01
    with RuntimeStart([], command(tmp_path, "import sys\nsys.exit('no laboratory')"), has_more=True) as start:
        start._guard.wait(60)
        with start.process(["more"]) as child:
            assert child.wait(60) == 1
            assert child.tail() == "no laboratory\n"


def test_a_runtime_that_waits_for_its_arguments_ends_with_whoever_began_it(tmp_path):  # R-X12
    text = f"""
import os
from onika.link.child.launcher import RuntimeStart
start = RuntimeStart([], {command(tmp_path, WAITS)!r}, has_more=True)
while b"up" not in os.read(start._output, 100): pass
print(start._guard.pid, flush=True)
os._exit(0)
"""
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, timeout=60, check=True)
    deadline = time.monotonic() + 60
    while is_running(int(done.stdout)):
        assert time.monotonic() < deadline, "the guard, and so the runtime, outlived its program"


def test_a_start_whose_guard_is_frozen_is_ended_like_any_other(tmp_path):  # R-X12
    with RuntimeStart([], command(tmp_path, WAITS), has_more=True) as start:
        os.kill(start._guard.pid, signal.SIGSTOP)
        while not guard.is_stopped(start._guard.pid):
            time.sleep(0.01)
    assert start._guard.returncode == 0
