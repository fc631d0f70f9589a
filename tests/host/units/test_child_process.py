import os

from onika.host.units.child_process import start
from onika.host.units.process_socket import ProcessSocket

ECHO = """
import argparse, os, socket
parser = argparse.ArgumentParser()
parser.add_argument("--fd", type=int)
parser.add_argument("--parent", type=int)
parser.add_argument("--word")
parser.add_argument("--pipe", type=int)
given = parser.parse_args()
os.write(given.pipe, b"inherited")
threads = os.environ["OMP_NUM_THREADS"] + os.environ["OPENBLAS_NUM_THREADS"] + os.environ["MKL_NUM_THREADS"]
said = f"{given.parent} {os.getppid()} {given.word} {threads} {os.read(0, 1)!r}"
socket.socket(fileno=given.fd).send(said.encode())
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
