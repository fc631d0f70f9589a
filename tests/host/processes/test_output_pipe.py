import os

import pytest

from onika.host.processes import output_pipe
from onika.host.processes.output_pipe import OutputPipe


@pytest.fixture
def pipe():
    read, write = os.pipe()
    yield read, write
    for descriptor in (read, write):
        os.close(descriptor)


def test_what_is_printed_comes_out(pipe):
    read, write = pipe
    print("grüezi", file=OutputPipe(write))
    assert os.read(read, 100).decode() == "grüezi\n"


def test_a_full_pipe_drops_text_and_never_blocks(pipe):  # law 30
    read, write = pipe
    out = OutputPipe(write)
    assert out.write("x" * 10_000_000) == 10_000_000
    assert out.write("more") == 4
    os.set_blocking(read, False)
    kept = 0
    while True:
        try:
            kept += len(os.read(read, 1 << 20))
        except BlockingIOError:
            break
    assert 0 < kept < 10_000_000
    out.write("again")
    assert os.read(read, 100) == b"again"


def test_a_closed_pipe_is_no_fault():  # law 30
    read, write = os.pipe()
    os.close(read)
    assert OutputPipe(write).write("into the void") == 13
    os.close(write)


def test_signs_that_cannot_be_encoded_are_replaced(pipe):
    read, write = pipe
    OutputPipe(write).write("\ud800!")
    assert os.read(read, 100) == b"?!"


def test_both_outputs_of_a_process_are_replaced(monkeypatch):
    opened = []
    monkeypatch.setattr(output_pipe, "OutputPipe", lambda descriptor: opened.append(descriptor) or descriptor)
    monkeypatch.setattr("sys.stdout", None)
    monkeypatch.setattr("sys.stderr", None)
    output_pipe.open_output_pipes()
    assert opened == [1, 2]


def test_it_can_be_written_to():
    assert OutputPipe.writable(object())
