"""Saving against a real system: killed at any moment, on a full disk, in a directory that is read only (R-B07)."""

import os
import random
import signal
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.site

SAVER = """
import os, signal, sys
from pathlib import Path
from onika.files import whole
path, texts = Path(sys.argv[1]), [sign * int(sys.argv[2]) for sign in "ab"]

def save_for_ever():
    while True:
        for text in texts:
            found = whole.write(path, text, whole.ANYTHING)
            assert found == whole.stamp(text), found
            os.write(1, b".")

for _ in sys.stdin:  # a fork for each word: what takes its time is the start of Python
    child = os.fork()
    if child == 0:
        save_for_ever()
    print(child, flush=True)
    os.waitpid(child, 0)
    print("ended", flush=True)
"""
ONCE = """
import sys
from pathlib import Path
from onika.files import whole
print(whole.write(Path(sys.argv[1]), "b" * 5, whole.ANYTHING))
"""


@pytest.mark.parametrize("length", [10, pytest.param(300_000, marks=pytest.mark.slow)])
def test_a_program_killed_while_it_saves_leaves_one_of_two_whole_files(tmp_path, length):  # R-B07
    path = tmp_path / "a.conf"
    path.write_text("a" * length)
    moments = random.Random(length)
    texts = {sign * length for sign in "ab"}
    half = 0
    command = [sys.executable, "-c", SAVER, path, str(length)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0) as starter:
        for _ in range(100):
            starter.stdin.write(b"again\n")
            saver = _number_among_dots(starter.stdout)
            starter.stdout.read(moments.randint(1, 20))
            for _ in range(moments.randint(0, 400)):
                path.stat()  # some microseconds, so that it is anywhere in its work
            os.kill(saver, signal.SIGKILL)
            assert b"ended" in starter.stdout.readline()
            assert path.read_text() in texts
            left = {path.name for path in tmp_path.iterdir()}
            half += len(left) - 1
            assert left <= {"a.conf", ".a.conf.saving"}
        starter.stdin.close()
    assert half > 0, "it was never killed in the middle: this test shows nothing"
    subprocess.run([sys.executable, "-c", ONCE, path], check=True)
    assert [path.name for path in tmp_path.iterdir()] == ["a.conf"]
    assert path.read_text() == "bbbbb"


def _number_among_dots(stream):
    """The child's number; the child may have saved already, which it says with dots."""
    return int(stream.readline().strip(b".\n"))


MOUNTED = """
import os, sys
from pathlib import Path
from onika.files import whole
disk = Path(sys.argv[1])
path = disk / "a.conf"
old = "old" * 1000
assert whole.write(path, old, whole.ABSENT) == whole.stamp(old)
(disk / "ballast").write_bytes(b"x" * 50_000)
print(whole.write(path, "new" * 100_000, whole.stamp(old)))
assert path.read_text() == old, "lost"
assert sorted(os.listdir(disk)) == ["a.conf", "ballast"], os.listdir(disk)
(disk / "ballast").unlink()
assert whole.write(path, "new", whole.stamp(old)) == whole.stamp("new")
os.system(f"mount -o remount,ro {disk}")
print(whole.write(path, "newer", whole.stamp("new")))
assert path.read_text() == "new"
"""


def test_a_full_disk_and_one_that_is_read_only_keep_the_old_file(tmp_path):  # R-B07
    apart = ["unshare", "--map-root-user", "--mount"]
    mount = f"mount -t tmpfs -o size=96k tmpfs {tmp_path}"
    tried = subprocess.run([*apart, "sh", "-c", mount], capture_output=True, text=True, check=False)
    if tried.returncode:
        pytest.skip(f"this system lets nobody mount a small disk: {tried.stderr.strip()}")
    script = f'{mount} && exec "{sys.executable}" -c "$1" {tmp_path}'
    ran = subprocess.run([*apart, "sh", "-c", script, "sh", MOUNTED], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    full, closed = ran.stdout.splitlines()
    assert full.startswith(f"{tmp_path}/a.conf cannot be saved: no space is left on that disk")
    assert closed.startswith(f"{tmp_path}/a.conf ")
    assert "can only be read" in closed or "may not be written" in closed


@pytest.mark.skipif(os.geteuid() == 0 and not Path("/usr/bin/setpriv").exists(), reason="needs another user")
def test_a_directory_or_file_that_is_closed_to_the_user_keeps_the_old_file(tmp_path):  # R-B07
    path = tmp_path / "lab" / "a.conf"
    path.parent.mkdir()
    path.write_text("old")
    code = (
        "import sys; from pathlib import Path; from onika.files import whole\n"
        "print(whole.write(Path(sys.argv[1]), 'new', '*'))"
    )
    as_nobody = ["setpriv", "--reuid=65534", "--clear-groups"] if os.geteuid() == 0 else []
    for parent in (tmp_path, *list(tmp_path.parents)[:3]):
        parent.chmod(0o755)

    def save():
        command = [*as_nobody, sys.executable, "-c", code, path]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    path.chmod(0o666)
    path.parent.chmod(0o555)
    assert save().startswith(f"{path} cannot be saved: this user is not permitted to")
    path.parent.chmod(0o777)
    path.chmod(0o444)
    assert save().startswith(f"{path} may not be written by you")
    assert path.read_text() == "old"
    assert [entry.name for entry in path.parent.iterdir()] == ["a.conf"]
    path.chmod(0o666)
    save()
    assert path.read_text() == "new"


@pytest.mark.parametrize(
    ("limit", "words"),
    [("RLIMIT_NOFILE, (12, 12)", "too many files and connections"), ("RLIMIT_FSIZE, (10**6, 10**6)", "shared memory")],
)
def test_a_run_without_descriptors_or_memory_is_told_why(limit, words):  # R-B07, R-X01
    code = f"import resource; resource.setrlimit(resource.{limit}); from onika.cli.commands import carry_out; "
    code += "raise SystemExit(carry_out(['run', 'go_home', '--no-fifo']))"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=60)
    assert ran.returncode == 1
    assert words in ran.stdout + ran.stderr
    assert "Traceback" not in ran.stdout + ran.stderr
