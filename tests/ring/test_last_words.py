from onika.ring.last_words import SIZE, LastWords
from onika.words.reason import NOTHING, Reason


def pair():
    """The process's end and its parent's."""
    memory = memoryview(bytearray(SIZE))
    return LastWords(memory), LastWords(memory), memory


def test_the_parent_sees_whose_code_runs_and_why_the_process_ended_itself():  # law 15, law 30
    process, parent, _ = pair()
    assert (parent.task, parent.reason) == ("", NOTHING)
    process.watch("flow0/sick")
    why = Reason.of("host.code_replaced", module="sick", what="onika.ring.drive.Drive")
    process.leave(why)
    assert (parent.task, parent.reason) == ("flow0/sick", why)


def test_a_reason_that_is_too_long_is_left_out():
    process, parent, _ = pair()
    process.leave(Reason.plain("x" * SIZE))
    assert parent.reason == NOTHING
    process.leave(Reason.plain("x" * 500))
    assert parent.reason.text == "x" * 500


def test_what_somebody_has_scribbled_there_says_nothing():
    for scribble in (b"\xff", b"\x05\x00", b"\x93"):
        process, parent, memory = pair()
        process.leave(Reason.plain("well"))
        memory[256:] = (scribble * SIZE)[: SIZE - 256]
        assert parent.reason == NOTHING
