import os

from onika.host.units.heartbeat import SIZE, Heartbeat
from onika.ring.segment import Segment
from onika.words.reason import Reason


def pair():
    """The process's end and the supervisor's end of one heartbeat."""
    segment = Segment.create("beat", SIZE)
    return Heartbeat(segment), Heartbeat(Segment.attach(os.dup(segment.fd)))


def test_the_supervisor_sees_when_the_process_was_last_alive():  # law 30
    process, supervisor = pair()
    assert supervisor.last_ns == 0
    process.beat()
    first = supervisor.last_ns
    process.beat()
    assert supervisor.last_ns >= first > 0


def test_whose_code_runs_is_seen_until_it_returns():  # law 15
    process, supervisor = pair()
    for task in ("flow0/jtraj", "flow0/a", "flow0/jtraj", "flow0/a~", ""):
        process.watch(task)
        assert supervisor.task == task


def test_a_name_longer_than_its_place_is_cut():
    process, supervisor = pair()
    process.watch("x" * 1000)
    assert supervisor.task == "x" * 256
    process.watch("é" * 1000)
    assert supervisor.task == "é" * 128
    process.watch("x" * 255 + "é")
    assert supervisor.task == "x" * 255 + "\N{REPLACEMENT CHARACTER}"


def test_it_is_a_page_of_memory_with_the_name_behind_a_line_of_words():
    segment = Segment.create("beat", SIZE)
    Heartbeat(segment).watch("flow0/a")
    assert len(segment.view) == 4096
    assert bytes(segment.view[:64]) == bytes(64)
    assert bytes(segment.view[64:71]) == b"flow0/a"


def test_long_work_is_announced_and_ends():
    process, supervisor = pair()
    assert not supervisor.takes_long
    process.is_slow(True)
    assert supervisor.takes_long
    process.is_slow(False)
    assert not supervisor.takes_long


def test_when_it_has_looked_at_its_code_is_seen():  # law 30
    process, supervisor = pair()
    assert supervisor.looked_ns == 0
    process.look()
    first = supervisor.looked_ns
    process.look()
    assert supervisor.looked_ns >= first > 0


def test_why_it_ended_itself_is_seen():  # law 30
    process, supervisor = pair()
    assert not supervisor.reason
    process.leave(Reason.plain("it had enough"))
    assert supervisor.reason.text == "it had enough"


def test_what_the_runtime_permits_and_confirms_its_unit_sees_and_last_words_stay():  # law 34
    process, supervisor = pair()
    process.leave(Reason.plain("x" * 1_500))
    supervisor.begin_words.permit(8)
    supervisor.begin_words.confirm(7)
    assert (process.begin_words.is_permitted(8), process.begin_words.is_confirmed(7)) == (True, True)
    assert supervisor.reason == Reason.plain("x" * 1_500)


def test_what_is_permitted_lies_at_the_end_far_behind_the_last_words():  # law 34
    segment = Segment.create("beat", SIZE)
    Heartbeat(segment).begin_words.permit(8)
    assert bytes(segment.view[3968:3976]) == (8).to_bytes(8, "little")
