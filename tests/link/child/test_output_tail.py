import os

from onika.link.child.output_tail import OutputTail


def piped(**bounds):
    read, write = os.pipe()
    return OutputTail(read, **bounds), write


def test_the_newest_output_is_kept_and_a_full_pipe_blocks_nobody():
    tail, write = piped(keep=10)
    for _ in range(40):
        os.write(write, b"x" * 60_000)  # far more than a pipe holds
    os.write(write, b"the end")
    os.close(write)
    tail.close()
    assert tail.text() == "xxxthe end"


def test_output_that_is_no_text_is_shown_as_such():
    tail, write = piped()
    os.write(write, b"\xffok")
    os.close(write)
    tail.close()
    assert tail.text() == "\\xffok"


def test_a_pipe_that_somebody_holds_open_is_let_go_and_what_it_held_is_kept():
    tail, write = piped()
    os.write(write, b"still here")
    tail.close(timeout_s=0.05)
    tail.close()
    assert tail.text() in ("still here", "")
    os.close(write)
