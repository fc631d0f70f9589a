import os
import subprocess
import sys

from onika.host.processes.child_process import start
from onika.host.processes.process_socket import ProcessSocket

ECHO = """
import argparse, os, socket, sys
parser = argparse.ArgumentParser()
parser.add_argument("--fd", type=int)
parser.add_argument("--parent", type=int)
parser.add_argument("--word")
parser.add_argument("--pipe", type=int)

def main(words):
    given = parser.parse_args(words)
    os.write(given.pipe, b"inherited")
    threads = os.environ["OMP_NUM_THREADS"] + os.environ["OPENBLAS_NUM_THREADS"] + os.environ["MKL_NUM_THREADS"]
    said = f"{given.parent} {os.getppid()} {given.word} {threads} {os.read(0, 1)!r}"
    socket.socket(fileno=given.fd).send(said.encode())

if __name__ == "__main__":
    main(sys.argv[1:])
"""


def test_a_process_gets_its_end_of_the_post_what_it_inherits_and_one_thread_for_algebra(
    tmp_path, monkeypatch
):  # law 14
    (tmp_path / "echo_back.py").write_text(ECHO)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    ours, theirs = ProcessSocket.pair()
    read, write = os.pipe()
    process = start("echo_back", theirs, ("--word", "hello", "--pipe", str(write)), (write,))
    assert theirs.fileno() == -1  # our copy of their end is closed: the end of the process will be seen
    assert process.wait(20) == 0
    assert ours.receive()[0].decode() == f"{os.getpid()} {os.getpid()} hello 111 b''"
    assert os.read(read, 20) == b"inherited"
    assert ours.receive() is None
    assert ours.is_closed
    for descriptor in (read, write):
        os.close(descriptor)
    ours.close()


def test_where_the_fork_server_has_ended_a_process_is_started_by_itself(tmp_path):  # law 17
    (tmp_path / "echo_back.py").write_text(ECHO)
    script = """
import os, signal, sys
from onika.host.processes.child_process import serve_forks, start
from onika.host.processes.process_socket import ProcessSocket
serve_forks()
(server,) = map(int, open(f"/proc/{os.getpid()}/task/{os.getpid()}/children").read().split())
for blow in (0, signal.SIGKILL, 0):
    os.kill(server, blow) if blow else None
    ours, theirs = ProcessSocket.pair()
    process = start("echo_back", theirs, ("--word", "hello", "--pipe", "1"), (1,))
    print(process.wait(20), type(process).__name__, ours.receive()[0].decode().split()[2:], flush=True)
"""
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{os.environ.get('PYTHONPATH', '')}"},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    said = "['hello', '111', \"b''\"]"
    kinds = ("ForkedProcess", "Popen", "Popen")
    assert done.stdout.split("\n") == [*(f"inherited0 {kind} {said}" for kind in kinds), ""], done.stderr
