import random

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.files.state.session_log import COLUMNS, HEADER, line, read

WORDS = ("insert_icon", "opengripC", "a1/2", "Start", "a1/0", "appl")


def written(place, at_s=770909683.0, session="aa", **content):
    record = "".join(f',"{name}":{value}' for name, value in content.items())
    return line((f"{at_s:.3f}", *WORDS), f'{{"s":"{session}","n":{place}{record}}}')


def keys(faults):
    return [(fault.place.line, fault.reason.key) for fault in faults]


def test_a_line_has_the_seven_columns_of_the_thesis_then_its_record():  # R-H01, R-H08, §6.2.2.4
    (read_line,), faults = read("\n".join((HEADER, written(0, act=1))), "s.log")
    assert faults == ()
    assert HEADER.split("\t")[:7] == list(COLUMNS)
    assert (read_line.at_s, read_line.event, read_line.object, read_line.id) == (770909683.0, *WORDS[:3])
    assert (read_line.associated, read_line.associated_id, read_line.window) == WORDS[3:]
    assert read_line.record == {"s": "aa", "n": 0, "act": 1} and read_line.number == 2


def test_the_log_of_the_thesis_is_read():  # R-H01, §6.2.2.4
    text = (
        "time\tevent\tobject\tobject's ID\tassoc. obj.\tassoc. ID\twindow\n"
        "770909683\ttry_new_appl\tnone\t0\tnone\t0\tappl\n"
        "770909685\tnew_appl\tUntitled-2\t3577432\tnone\t0\tappl\n\n"
        "770909690\tselect_icon\topengripC\t3496920\tnone\t0\tdict\n"
    )
    lines, faults = read(text, "p3.raw")
    assert faults == ()
    assert [(each.at_s, each.event) for each in lines] == [
        (770909683.0, "try_new_appl"),
        (770909685.0, "new_appl"),
        (770909690.0, "select_icon"),
    ]
    assert all(not each.record for each in lines)


def test_lines_come_in_the_order_of_the_session_whatever_their_order_in_the_file():  # R-H08
    lines = [written(place) for place in range(20)]
    random.Random(7).shuffle(lines)
    read_lines, faults = read("\n".join(lines), "s.log")
    assert [each.place for each in read_lines] == list(range(20)) and faults == ()


def test_lines_that_lack_stand_twice_or_belong_to_others_are_named():  # R-H08
    text = "\n".join([written(0), written(1), written(4), written(4), written(5, session="bb"), written(6)])
    lines, faults = read(text, "s.log")
    assert [each.place for each in lines] == [0, 1, 4, 6]
    assert keys(faults) == [
        (5, "replay.other_session"),
        (3, "replay.lines_lack"),
        (4, "replay.line_twice"),
        (6, "replay.lines_lack"),
    ]


def test_a_changed_line_is_named_and_taken_as_it_stands():  # R-H08
    lines, faults = read("\n".join([written(0), written(1).replace("opengripC", "closegripC")]), "s.log")
    assert keys(faults) == [(2, "replay.line_changed")]
    assert lines[1].object == "closegripC"


@pytest.mark.parametrize("text", ["nonsense", "soon\t" + "\t".join(WORDS), "1\t2\t3", "-1\ta\tb\tc\td\te\tf", "\x00"])
def test_what_is_no_line_is_left_out_and_named(text):  # R-H08
    lines, faults = read("\n".join([written(0), text, written(1)]), "s.log")
    assert [each.place for each in lines] == [0, 1]
    assert keys(faults) == [(2, "replay.no_line")]


@given(st.data())
@settings(max_examples=examples(60), deadline=None)
def test_a_log_cut_anywhere_is_read_up_to_there(data):  # R-H08
    lines = [written(place) for place in range(4)]
    text = "\n".join(lines)
    cut = data.draw(st.integers(1, len(text) - 1))
    read_lines, faults = read(text[:cut], "s.log")
    whole = [each.place for each in read_lines if each.record and each.place >= 0]
    assert whole == list(range(len(whole)))
    ends = {sum(len(each) + 1 for each in lines[:count]) for count in range(1, 5)}
    is_bare = text[:cut].count("\t") == 6  # seven columns and nothing behind: it reads as a log of the source's form
    assert faults or cut in ends or cut + 1 in ends or (is_bare and not whole)


@given(st.text(max_size=200))
@settings(max_examples=examples(60), deadline=None)
def test_no_text_at_all_raises(text):  # R-H08
    lines, faults = read(text, "s.log")
    assert len(lines) + len(faults) <= 2 * (text.count("\n") + 1)
