import json
from pathlib import Path

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.files.trail import head_of, line, older, read, torn_hash, usual_path
from onika.words.reason import Reason

DEEDS = ("begins", "Take", "Stop", "Release", "gone")


def written(path, deeds=DEEDS, head=""):
    """A file of records, and its head."""
    data = b""
    for number, deed in enumerate(deeds):
        record = {"what": deed} | ({} if number else {"before": head})
        text, head = line(head, record)
        data += text
    path.write_bytes(data)
    return head


def test_what_was_written_is_read_whole(tmp_path):  # R-X12
    head = written(tmp_path / "a")
    trail = read([tmp_path / "a"])
    assert [record["what"] for record in trail.records] == list(DEEDS)
    assert (trail.faults, trail.notes, trail.head) == ([], [], head)


@settings(max_examples=examples(200), deadline=None)
@given(st.integers(0, 10_000), st.integers(0, 7))
def test_whichever_bit_is_changed_it_shows(tmp_path_factory, at, bit):  # R-X12
    path = tmp_path_factory.getbasetemp() / "flipped"
    head = written(path)
    data = bytearray(path.read_bytes())
    data[at % len(data)] ^= 1 << bit
    path.write_bytes(data)
    trail = read([path])
    assert trail.faults or trail.head != head


@pytest.mark.parametrize("gone", range(1, len(DEEDS) - 1))
def test_a_line_that_is_taken_out_shows(tmp_path, gone):  # R-X12
    written(tmp_path / "a")
    lines = (tmp_path / "a").read_bytes().splitlines(keepends=True)
    (tmp_path / "a").write_bytes(b"".join(lines[:gone] + lines[gone + 1 :]))
    (fault,) = read([tmp_path / "a"]).faults
    assert fault.place.line == gone + 1


def test_lines_in_another_order_show(tmp_path):  # R-X12
    written(tmp_path / "a")
    first, second, third, *rest = (tmp_path / "a").read_bytes().splitlines(keepends=True)
    (tmp_path / "a").write_bytes(b"".join([first, third, second, *rest]))
    assert read([tmp_path / "a"]).faults


def test_a_line_with_a_hash_of_ones_own_does_not_fit_the_next(tmp_path):  # R-X12
    written(tmp_path / "a")
    lines = (tmp_path / "a").read_bytes().splitlines(keepends=True)
    lines[1], _ = line(lines[0][:64].decode(), {"what": "Release"})
    (tmp_path / "a").write_bytes(b"".join(lines))
    (fault,) = read([tmp_path / "a"]).faults
    assert fault.place.line == 3


def test_lines_off_the_end_show_to_who_knows_the_head(tmp_path):  # R-X12
    head = written(tmp_path / "a")
    data = (tmp_path / "a").read_bytes()
    (tmp_path / "a").write_bytes(b"".join(data.splitlines(keepends=True)[:-1]))
    trail = read([tmp_path / "a"])
    assert trail.faults == []
    assert head not in trail.hashes


def test_a_chain_goes_on_from_file_to_file(tmp_path):  # R-X12
    path = tmp_path / "a"
    head = written(tmp_path / "a.2")
    head = written(tmp_path / "a.1", head=head)
    written(path, head=head)
    assert [item.name for item in older(path)] == ["a.2", "a.1", "a"]
    trail = read(older(path))
    assert (len(trail.records), trail.faults, trail.begins) == (15, [], "")
    (tmp_path / "a.1").unlink()
    (fault,) = read(older(path)).faults
    assert fault.reason == Reason.of("files.trail_file_order", head="bf1de8aa3add", before="14f5e8f02fc7")
    (tmp_path / "a.2").unlink()
    trail = read(older(path))
    assert (trail.faults, trail.begins) == ([], head)


def test_a_file_without_its_beginning_says_so(tmp_path):  # R-X12
    written(tmp_path / "a")
    (tmp_path / "a").write_bytes(b"".join((tmp_path / "a").read_bytes().splitlines(keepends=True)[1:]))
    assert "files.trail_begins_midst" in [fault.reason.key for fault in read([tmp_path / "a"]).faults]


@pytest.mark.parametrize("left", [1, 40, 65, 70])
def test_what_a_crash_has_cut_off_is_no_fault_where_the_next_line_knows(tmp_path, left):  # R-X12
    path = tmp_path / "a"
    head = written(path)
    torn = line(head, {"what": "Take"})[0][:left]
    existing, _ = line(head, {"what": "begins", "torn": torn_hash(torn)})
    whole = path.read_bytes()
    path.write_bytes(whole + torn)
    trail = read([path])
    assert (trail.faults, len(trail.notes)) == ([], 1)
    path.write_bytes(whole + torn + b"\n" + existing)
    trail = read([path])
    assert (trail.faults, len(trail.notes), len(trail.records)) == ([], 1, 6)
    path.write_bytes(whole + b"x" + torn + b"\n" + existing)
    assert read([path]).faults


def test_the_head_is_found_from_the_end_alone(tmp_path):
    head = written(tmp_path / "a")
    data = (tmp_path / "a").read_bytes()
    assert head_of(data[-300:]) == (head, b"")
    assert head_of(data + b"abc") == (head, b"abc")
    assert head_of(b"nothing") == ("", b"nothing")


def test_deeply_nested_and_foreign_records_are_faults_not_crashes(tmp_path):
    (tmp_path / "a").write_bytes(b"0" * 64 + b" {" + b'"a":{' * 5000 + b"}" * 5001 + b"\n" + b"\xff\n[]\n")
    trail = read([tmp_path / "a"])
    assert (trail.records, len(trail.faults) + len(trail.notes)) == ([], 3)


def test_it_lies_in_the_state_directory():
    assert usual_path({"XDG_STATE_HOME": "/s"}) == Path("/s/onika/audit/audit.log")
    assert usual_path({"XDG_STATE_HOME": "no", "HOME": "/h"}) == Path("/h/.local/state/onika/audit/audit.log")


def test_a_record_is_json_on_one_line():
    text, head = line("", {"what": "a\nb", "who": "Ünïcode"})
    assert text.count(b"\n") == 1
    assert json.loads(text[65:]) == {"what": "a\nb", "who": "Ünïcode"}
    assert text[:64].decode() == head


@pytest.mark.parametrize("other", [b"\x89PNG\r\n\x1a\n" + bytes(range(256)), b"words\nof another\nfile\n", b"a word"])
def test_a_file_of_something_else_is_no_whole_trail(tmp_path, other):  # R-X12
    (tmp_path / "audit.log").write_bytes(other)
    assert read([tmp_path / "audit.log"]).faults


def test_lines_that_are_made_into_something_else_at_the_end_show(tmp_path):  # R-X12
    first, head = line("", {"before": "", "do": "a"})
    second, _ = line(head, {"do": "b"})
    (tmp_path / "audit.log").write_bytes(first + b"x" + second)
    assert read([tmp_path / "audit.log"]).faults
    (tmp_path / "audit.log").write_bytes(first + second[:-9])
    result = read([tmp_path / "audit.log"])
    assert (result.faults, len(result.notes)) == ([], 1)
