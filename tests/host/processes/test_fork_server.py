"""Each test has a process of its own for the runtime: one with threads, as the test's, must not be copied."""

import os
import signal
import subprocess
import sys
import textwrap

import pytest

TELLING = """
import os, socket, sys, time

def main(words):
    post = socket.socket(fileno=int(words[1]))
    match words[3]:
        case "tell":
            listed = os.listdir("/proc/self/fd")
            open_now = sorted(int(number) for number in listed if os.path.exists(f"/proc/self/fd/{number}"))
            title = open("/proc/self/cmdline").read().rstrip("\\0")
            post.send(repr((os.getppid(), os.getsid(0), os.getpid(), os.read(0, 1), open_now, title)).encode())
        case "leave":
            sys.exit(7)
        case "raise":
            raise ValueError("it fails")
        case "stay":
            post.send(b"here")
            post.recv(1)
            post.send(b"still here")
"""

RUNTIME = """
import os, signal, socket, subprocess, sys, time
from onika.host.processes.fork_server import BeginProcess, ForkServer

secret = os.open("/dev/zero", os.O_RDONLY)
server = ForkServer()

def begin(word, own_group=False, number=40):
    ours, theirs = socket.socketpair()
    words = ("--fd", str(number), "--word", word)
    process = server.begin(BeginProcess("telling", words, (number,), own_group), (theirs.fileno(),))
    theirs.close()
    return ours, process

"""


@pytest.fixture
def runtime(tmp_path):
    (tmp_path / "telling.py").write_text(TELLING)

    def run(script):
        return subprocess.run(
            [sys.executable, "-c", RUNTIME + textwrap.dedent(script)],
            env={**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{os.environ.get('PYTHONPATH', '')}"},
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )

    return run


def test_a_copy_is_a_child_of_the_runtime_and_has_what_was_passed_to_it_and_nothing_else(runtime):  # R-A15
    done = runtime("""
        ours, process = begin("tell", own_group=True)
        parent, session, pid, read, numbers, title = eval(ours.recv(1000))
        print(parent == os.getpid(), session == pid == process.pid, read, numbers, title.strip())
        print(process.wait(20), process.returncode, process.poll())
    """)
    assert done.stdout.splitlines() == ["True True b'' [0, 1, 2, 40] telling --fd 40 --word tell", "0 0 0"], done.stderr


def test_how_a_copy_ended_is_known(runtime):  # R-E10
    done = runtime("""
        print(begin("leave")[1].wait(20))
        print(begin("raise")[1].wait(20))
        ours, process = begin("stay")
        ours.recv(10)
        print(process.poll())
        try:
            process.wait(0.0)
        except subprocess.TimeoutExpired:
            print("it lives")
        process.kill()
        print(process.wait(20))
        process.kill()
        print(len(open(f"/proc/{os.getpid()}/task/{os.getpid()}/children").read().split()))
    """)
    assert done.stdout.splitlines() == ["7", "1", "None", "it lives", "-9", "1"], done.stderr
    assert "ValueError: it fails" in done.stderr


def test_whom_a_server_has_begun_goes_on_when_it_has_ended(runtime):  # law 17
    done = runtime("""
        ours, process = begin("stay")
        ours.recv(10)
        server.close()
        print(begin("tell")[1])
        ours.send(b".")
        print(ours.recv(20).decode(), process.wait(20))
    """)
    assert done.stdout.splitlines() == ["None", "still here 0"], done.stderr


def test_a_server_that_is_held_is_ended_and_begins_nobody(runtime):  # law 17
    done = runtime("""
        (pid,) = map(int, open(f"/proc/{os.getpid()}/task/{os.getpid()}/children").read().split())
        os.kill(pid, signal.SIGSTOP)
        begun = time.monotonic()
        print(begin("tell")[1], time.monotonic() - begun < 15, os.path.exists(f"/proc/{pid}"))
    """)
    assert done.stdout.splitlines() == ["None True False"], done.stderr


def test_a_server_ends_with_its_runtime(runtime):  # R-X12
    done = runtime("""
        begin("tell")[0].recv(1000)
        os.kill(os.getpid(), signal.SIGKILL)
    """)
    assert done.returncode == -signal.SIGKILL  # and its outputs have ended, too, else this would still wait
