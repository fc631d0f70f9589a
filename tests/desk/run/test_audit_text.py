from onika.desk.run.audit_text import lines, sentence, verdict
from onika.files.trail import TrailReading
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

STOP = {
    "at": "2026-11-21T21:35:41.755+00:00", "what": "Stop", "who": "ann#2", "role": "viewer", "address": "192.0.2.7",
    "about": "cause=enough", "result": "done",
}  # fmt: skip


def test_a_record_is_one_line_with_who_from_where_what_and_what_came_of_it():  # R-X12
    expected = "2026-11-21T21:35:41.755+00:00  ann#2 viewer from 192.0.2.7  Stop cause=enough: done"
    assert str(sentence(STOP)) == expected
    assert [str(line) for line in lines(TrailReading(records=[STOP, STOP]))] == [expected] * 2


def test_code_is_named_in_short_and_what_is_missing_is_left_out():
    assert (
        str(sentence({"at": "T", "what": "Swap", "on": "s0", "code": ["a" * 64]})) == f"T  -  Swap s0 code {'a' * 12}"
    )


def test_nothing_in_a_record_steers_the_terminal():
    assert "\x1b" not in str(sentence(STOP | {"about": "\x1b[2J"}))


def test_the_verdict_names_the_head_or_the_faults():  # R-X12
    assert str(verdict(TrailReading(records=[STOP], head="abc"))) == "1 record, whole; head abc"
    assert "going on from" in str(verdict(TrailReading(begins="abc")))
    assert (
        str(
            verdict(TrailReading(faults=[Fault(Place("f", 1), Reason.plain("expected a, found b"), Reason.plain("c"))]))
        )
        == "0 records, NOT WHOLE: 1 fault"
    )
