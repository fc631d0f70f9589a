"""Commands side by side: what each prints and how it ends comes back, and who is behind gives way."""

import os
import select
import signal
import subprocess
import sys
from pathlib import Path

import pytest

import side_by_side

PATIENCE_S = 60.0


def carried_out(capfd, *words):
    """The code it ends with, and all that was printed."""
    former = signal.getsignal(signal.SIGTERM)
    try:
        code = side_by_side.main(words)
    finally:
        signal.signal(signal.SIGTERM, former)
    return code, capfd.readouterr().out


def test_those_in_front_come_one_after_another_and_what_the_last_one_says_comes_at_the_end(capfd):
    code, output = carried_out(capfd, "echo first; echo one", "echo second", "--behind", "echo last >&2")
    assert code == 0
    assert output.index("one") < output.index("second\n") < output.index("last\n")


@pytest.mark.parametrize("failing", range(3))
def test_all_are_carried_out_though_one_fails(capfd, failing):
    first, second, behind = (f"echo did {k}; exit {3 * (k == failing)}" for k in range(3))
    code, output = carried_out(capfd, first, second, "--behind", behind)
    assert code == 1
    assert all(f"did {k}\n" in output for k in range(3))


@pytest.mark.parametrize("failing", range(2))
def test_the_last_lines_of_what_failed_come_once_more_at_the_end(capfd, failing):
    front, behind = (f"seq -f '{name} %g' 100; exit {k == failing:d}" for k, name in enumerate(("front", "behind")))
    _, output = carried_out(capfd, front, "--behind", behind)
    name = ("front", "behind")[failing]
    _, end = output.split("\nfailed: ")
    assert end.splitlines()[1:] == [f"{name} {k}" for k in range(61, 101)]


def test_who_is_behind_is_there_at_once_and_gives_way(capfd, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    niceness = f"{sys.executable} -c 'import os; print(os.nice(0), os.getsid(0) == os.getppid())'"
    code, output = carried_out(capfd, f"cat {tmp_path}/pipe", "--behind", f"{niceness}; echo hello > {tmp_path}/pipe")
    assert code == 0
    assert "hello\n" in output
    assert f"\n{min(19, os.nice(0) + side_by_side.GIVES_WAY)} True\n" in output


def test_those_behind_are_there_at_once_and_are_shown_one_after_another(capfd, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    words = ("--behind", f"echo gives; echo hello > {tmp_path}/pipe", "--behind", f"cat {tmp_path}/pipe; exit 1")
    code, output = carried_out(capfd, "true", *words)  # one after another would wait for ever
    assert code == 1
    assert output.index("gives\n") < output.index("hello\n")
    assert output.rstrip().endswith(f"failed: {words[3]}\nhello")


def test_with_it_ends_who_is_behind(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    words = [sys.executable, side_by_side.__file__, f"cat {tmp_path}/pipe", "--behind"]
    words.append(f"echo $$ > {tmp_path}/pipe; exec sleep 1000")
    with subprocess.Popen([*words], stdout=subprocess.PIPE, text=True) as tool:
        assert tool.stdout is not None
        printed = [tool.stdout.readline() for _ in range(3)]
        behind = int(next(line for line in printed if line.strip().isdigit()))
        handle = os.pidfd_open(behind)
        tool.send_signal(signal.SIGTERM)
        tool.stdout.read()
        assert select.select([handle], [], [], PATIENCE_S)[0]
        os.close(handle)
    assert tool.returncode == 128 + signal.SIGTERM


def test_with_it_ends_who_is_behind_also_when_it_waits_for_nobody_else(tmp_path):
    words = [sys.executable, side_by_side.__file__, "true", "--behind", "exec sleep 1000"]
    with subprocess.Popen([*words], stdout=subprocess.PIPE, text=True) as tool:
        assert tool.stdout is not None
        assert [tool.stdout.readline().partition(":")[0].strip() for _ in range(2)] == ["true", "true"]
        (behind,) = children(tool.pid)
        handle = os.pidfd_open(behind)
        asleep(tool.pid)
        tool.send_signal(signal.SIGTERM)
        tool.stdout.read()
        assert select.select([handle], [], [], PATIENCE_S)[0]
        os.close(handle)
    assert tool.returncode == 128 + signal.SIGTERM


def children(pid):
    return [int(one) for one in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


def asleep(pid):
    """Until a process waits: it has been seen so ten times, one after the other."""
    seen = 0
    while seen < 10:
        seen = seen + 1 if Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "S" else 0
