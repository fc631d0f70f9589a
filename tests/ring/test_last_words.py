from msgspec.msgpack import encode

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


def test_a_process_may_say_again_whose_code_it_runs():
    process, parent, _ = pair()
    for task in ("flow0/move", "", "flow0/move"):
        process.watch(task)
        assert parent.task == task


def test_a_name_that_is_too_long_is_cut_and_one_that_is_no_text_can_be_told():
    process, parent, memory = pair()
    process.watch("x" * 300)
    assert parent.task == "x" * 256
    process.watch("~x~")
    assert parent.task == "~x~"
    memory[0] = 0xFF
    assert parent.task == "\ufffdx~"


def test_name_and_reason_have_their_places_and_fill_two_kilobytes():
    assert SIZE == 2048
    process, parent, memory = pair()
    overhead = len(encode(Reason.plain("x" * 1700))) - 1700
    longest = Reason.plain("x" * (2048 - 258 - overhead))
    process.leave(longest)
    assert int.from_bytes(memory[256:258], "little") == 2048 - 258
    assert parent.reason == longest
    process.leave(Reason.plain(longest.text + "x"))
    assert parent.reason == longest, "one that does not fit is left out"


def test_a_length_that_cannot_be_says_nothing():
    process, parent, memory = pair()
    process.leave(Reason.plain("well"))
    assert parent.reason.text == "well"
    for length in (0, 1, 2048 - 258, 0xFFFF):
        memory[256:258] = length.to_bytes(2, "little")
        assert parent.reason == NOTHING


def test_what_somebody_has_scribbled_there_says_nothing():
    for scribble in (b"\xff", b"\x05\x00", b"\x93"):
        process, parent, memory = pair()
        process.leave(Reason.plain("well"))
        memory[256:] = (scribble * SIZE)[: SIZE - 256]
        assert parent.reason == NOTHING
