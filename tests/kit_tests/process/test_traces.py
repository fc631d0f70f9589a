"""What a program leaves on a machine is found, also where it has left the family."""

import os
import subprocess
import sys

import pytest

from kit.process.traces import Traces

LEAVES = """
import os, subprocess, sys, tempfile
tempfile.mkstemp()
silent = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
child = subprocess.Popen([sys.executable, "-c", "import os; os.read(0, 1)"], start_new_session=True, **silent)
print(child.pid, flush=True)
"""


@pytest.mark.site
def test_a_process_and_a_file_that_a_program_leaves_are_found_and_ended(tmp_path):  # R-F01
    traces = Traces(tmp_path)
    read, write = os.pipe()
    done = subprocess.run(
        [sys.executable, "-c", LEAVES],
        stdin=read,
        capture_output=True,
        check=True,
        timeout=60,
        env=os.environ | traces.environment,
    )
    (left,) = traces.processes()
    assert left == int(done.stdout)
    words, path = traces.left_over(0.0)
    assert "os.read(0, 1)" in words
    assert path.startswith(str(tmp_path))
    traces.end()
    assert traces.left_over(2.0) == [path]
    for descriptor in (read, write):
        os.close(descriptor)


def test_what_others_have_on_the_machine_is_not_counted(tmp_path):
    assert Traces(tmp_path).left_over(0.0) == []
