"""A runtime on another machine is started by ssh: by a real sshd, which is this machine's."""

import contextlib
import os
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic

import pytest

from kit.machine.ssh_server import IS_THERE, SshServer
from onika.desk.run.remote_runtime import RemoteRuntime
from onika.files.state.staying_runtime import staying_runtime
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.ssh_address import SshAddress
from onika.link.starting.ssh_opening import SshOpening
from onika.wire import live, request
from onika.wire.runtime_standing import Standing

pytestmark = pytest.mark.site

ONIKA = Path(sys.executable).with_name("onika")


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    if not IS_THERE and os.environ.get("CI"):
        pytest.fail("There is no ssh or sshd on the PATH, and under CI they must be tried.")
    if not IS_THERE:
        pytest.skip("There is no ssh or sshd on the PATH.")
    server = SshServer(tmp_path_factory.mktemp("machine"))
    yield server
    server.close()


def at(server, **ways):
    return RemoteRuntime(SshOpening(SshAddress("robot", program=str(server.program), **ways), str(server.ssh)))


def standing(runtime):
    answer = runtime.ask(live.Survey())
    assert isinstance(answer, Standing)
    return answer


def processes(server):
    """Who lives with the state of that machine, and is no sshd."""
    wanted, mine = f"XDG_STATE_HOME={server.state}".encode(), set()
    for path in Path("/proc").glob("[0-9]*/environ"):
        with contextlib.suppress(OSError):
            if wanted in path.read_bytes().split(b"\0"):
                mine.add(int(path.parent.name))
    return mine


def gone(server, within_s=10.0):
    until = monotonic() + within_s
    while processes(server):
        if monotonic() > until:
            return False
    return True


def test_a_run_there_is_as_one_here_and_leaves_nothing(server):  # R-A15 R-F02
    words = [ONIKA, "run", "go_home", "--runtime", f"ssh://robot{server.program}?virtual"]
    there = subprocess.run(words, check=False, capture_output=True, text=True, env=server.environment(), timeout=60)
    here = subprocess.run(
        [ONIKA, "run", "go_home", "--virtual"], check=True, capture_output=True, text=True, timeout=60
    )
    assert there.returncode == 0, there.stdout + there.stderr
    assert there.stdout.splitlines()[-1] == here.stdout.splitlines()[-1], "the same hash"
    assert gone(server)


def test_what_was_started_there_ends_when_whoever_called_is_killed(server):  # R-A15 R-X12
    words = [ONIKA, "console", f"ssh://robot{server.program}?unit=left&unit=right"]
    with subprocess.Popen(
        words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=server.environment()
    ) as console:
        assert "left, right" in console.stdout.readline()
        assert processes(server)
        console.kill()
    assert gone(server), "the drives were held, and everything ended"


def test_when_the_session_is_cut_the_runtime_ends_and_the_loss_says_so(server):  # R-A15 R-F04
    with at(server, is_virtual=True) as runtime:
        assert standing(runtime).is_virtual
        os.kill(runtime._opening._session._process.pid, signal.SIGKILL)
        with pytest.raises(LinkLost) as lost:
            while True:
                runtime.ask(live.Survey())
    assert lost.value.cause is LossCause.OVER
    assert "the ssh session with ssh://robot" in str(lost.value)
    assert gone(server)


def test_one_that_stays_is_found_again_by_whoever_comes_and_ends_when_it_is_told_to(server):  # R-A15
    with at(server, is_virtual=True, stays=True) as runtime:
        runtime.ask(live.Change("kept"))
    staying = staying_runtime(server.state / "onika" / "staying")
    assert staying is not None
    with at(server, stays=True) as runtime:
        assert standing(runtime).is_virtual, "what is there is not started anew"
        os.kill(runtime._opening._session._process.pid, signal.SIGKILL)
        assert standing(runtime).is_virtual, "a cut session is begun anew, and the runtime is the same"
        assert staying_runtime(server.state / "onika" / "staying") == staying
        assert isinstance(runtime.ask(request.Quit()), request.Done)
    assert gone(server)
    assert staying_runtime(server.state / "onika" / "staying") is None


@pytest.mark.parametrize(
    ("known", "words"), [((), "Host key verification failed"), (("other",), "Host key verification failed")]
)
def test_a_machine_whose_key_is_not_the_known_one_is_not_spoken_to(server, known, words):  # R-A15
    server.know(*known)
    try:
        with pytest.raises(LinkLost) as lost, at(server):
            pass
    finally:
        server.know("host")
    assert lost.value.cause is LossCause.UNREACHABLE, lost.value
    assert words in str(lost.value)
    assert "ssh robot" in str(lost.value), "what to try by hand"


def test_where_there_is_no_onika_that_is_said_with_what_the_shell_said(server):  # R-A15
    with (
        pytest.raises(LinkLost) as lost,
        RemoteRuntime(SshOpening(SshAddress("robot", program="/not/there/onika"), str(server.ssh))),
    ):
        pass
    assert "/not/there/onika" in str(lost.value)
    assert "name its path" in str(lost.value)
