"""One rule for all formats of Appendix A: what is written is read again, and damage is reported (R-B07, R-B08).

A load is wrong when no fault is told and the model is not what the text says by Appendix A. What a text says is judged
by the naive readers of `tests/files/independent`, which share no code with ours.
"""

from collections.abc import Callable

import pytest
from hypothesis import given, settings, strategies as st
from tests.files.models import FORMATS, Format, tasks

from kit.examples import examples
from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model.picture import SIZE
from onika.model.task import Task

JUNK = ["?? garbled ??", "xyz", "EOF x", "\x00", "FREQ", "8" * 31, "UI none none"]


def every_format(test: Callable[..., None]) -> Callable[..., None]:
    return pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)(test)


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_what_is_written_is_read_again_as_the_same_model_and_the_same_bytes(form: Format, data: st.DataObject) -> None:
    model = data.draw(form.models)  # R-B08
    text = form.write(model)
    read, faults = form.read(text)
    assert faults == ()
    assert read == model
    assert form.write(read) == text


@every_format
@given(data=st.data())
@settings(max_examples=15, deadline=None)
def test_a_file_cut_at_any_line_is_reported(form: Format, data: st.DataObject) -> None:
    lines = form.write(data.draw(form.models)).splitlines(keepends=True)  # R-B07
    for end in range(len(lines)):
        _, faults = form.read("".join(lines[:end]))
        assert faults, f"cut before line {end + 1}"


@every_format
@given(
    data=st.data(), junk=st.sampled_from(["?? garbled ??", "xyz", "EOF x", "\x00", "FREQ", "8" * 31, "UI none none"])
)
@settings(max_examples=examples(30), deadline=None)
def test_a_line_replaced_by_junk_is_reported(form: Format, data: st.DataObject, junk: str) -> None:
    lines = form.write(data.draw(form.models)).splitlines()  # R-B07
    at = data.draw(st.sampled_from([at for at, line in enumerate(lines) if line]))
    meaning, _ = form.read("\n".join(lines) + "\n")
    is_value = lines[at].startswith("UI ") and junk.startswith("UI ")  # as good a text as the one that stood there
    lines[at] = junk
    read, faults = form.read("\n".join(lines) + "\n")
    free = form.name == "task" and "LOCAL" in [line.strip() for line in lines[:at]] and junk in ("xyz", "UI none none")
    assert faults or read == meaning or free or is_value


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_a_line_with_a_control_sign_is_reported(form: Format, data: st.DataObject) -> None:
    text = form.write(data.draw(form.models))
    at = data.draw(st.integers(0, len(text) - 1))
    sign = data.draw(st.sampled_from("\x00\x01\x1b\x7f\x85\r"))
    _, faults = form.read(text[:at] + sign + "x" + text[at:])
    line = text.count("\n", 0, at) + 1
    assert line in [fault.place.line for fault in faults]


@every_format
@given(data=st.data())
@settings(max_examples=15, deadline=None)
def test_two_lines_exchanged_are_reported_or_mean_the_same(form: Format, data: st.DataObject) -> None:
    lines = form.write(data.draw(form.models)).splitlines()  # reading 41
    solid = [at for at, line in enumerate(lines) if line]
    first, other = data.draw(st.sampled_from(solid)), data.draw(st.sampled_from(solid))
    is_order_free = lines[first].split()[0] == lines[other].split()[0] or form.name in ("picture", "task")
    is_order_free |= form.is_ours  # a line that may be lacking may stand in either of two blocks
    meaning, _ = form.read("\n".join(lines) + "\n")
    lines[first], lines[other] = lines[other], lines[first]
    read, faults = form.read("\n".join(lines) + "\n")
    assert faults or read == meaning or is_order_free


@every_format
@given(text=st.text(max_size=200))
@settings(max_examples=examples(30), deadline=None)
def test_no_text_at_all_raises_an_exception(form: Format, text: str) -> None:
    _, faults = form.read(text)
    meant = [line.strip() for line in text.splitlines() if line.strip() and not line.startswith("#")]
    is_empty = form.name in ("configuration", "preferences", "buttons") and meant == ["EOF"]  # and of an old version
    assert faults or is_empty
    assert all(str(fault) and fault.place.file == "f" for fault in faults)


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_lines_in_any_number_and_order_give_a_model_or_a_fault(form: Format, data: st.DataObject) -> None:
    lines = [line for line in form.write(data.draw(form.models)).splitlines() if line]  # R-B07
    soup = data.draw(st.lists(st.sampled_from([*lines, "EOF"]), max_size=12))
    for end in ("", "EOF\n"):
        model, faults = form.read("".join(line + "\n" for line in soup) + end)
        assert model is not None or faults


@every_format
@given(data=st.data())
@settings(max_examples=15, deadline=None)
def test_comments_and_blank_lines_mean_nothing(form: Format, data: st.DataObject) -> None:
    if form.name == "picture":
        return  # "nor are there any other lines in the files" (A.8)
    model = data.draw(form.models)
    lines = form.write(model).splitlines()
    for _ in range(3):
        lines.insert(data.draw(st.integers(0, len(lines))), data.draw(st.sampled_from(["", " \t", "# x", "\t# EOF"])))
    blank = data.draw(st.sampled_from(["\n", "\r\n", "\t\n"]))
    assert form.read(blank.join(lines)) == (model, ())


@every_format
@given(data=st.data())
@settings(max_examples=10, deadline=None)
def test_a_newer_version_is_refused_with_one_clear_fault(form: Format, data: st.DataObject) -> None:
    text = form.write(data.draw(form.models))  # R-B06
    if form.name in ("task", "picture"):
        return  # the two formats that have no VERSION
    assert text.startswith("VERSION")
    head, body = text.split("\n", 1)
    _, faults = form.read(f"VERSION 2.1\nNEWWORD x\n{body}")
    key = "files.version_newer_extended" if form.is_extended else "files.version_newer"
    assert [(fault.reason.key, fault.reason.args["given"]) for fault in faults] == [(key, "2.1")]
    if head.endswith("1.3"):
        read, _ = form.read(f"VERSION 1.2\n{body}")
        assert form.write(read) == text


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_what_1_3_can_say_is_written_as_1_3_and_the_rest_is_refused_under_it(form: Format, data: st.DataObject) -> None:
    text = form.write(data.draw(form.models))  # R-B06, R-B09
    head, _, body = text.partition("\n")
    if not form.is_extended:
        assert "2.0" not in head
        return
    if form.is_ours:
        assert head == "VERSION     2.0"
        assert form.read("VERSION 1.3\n" + body)[1]
        return
    words = {line.split(" ")[0] for line in body.splitlines()}
    needed = words & {"TARGET", "DESCIN", "ARM", "BRANCH", "MARKERIF", "WHILEIF", "GROUP", "DIMENSION"}
    if form.name == "configuration":
        needed |= words & {"AS", "SVARALIAS", "LOCAL", "NOLOCAL"}
    rows = [line.split()[-1] for line in body.splitlines() if line.startswith("PICT")]
    needed |= {"PICT"} if any(len(row) > SIZE for row in rows) else set()
    assert head == ("VERSION     2.0" if needed else "VERSION     1.3")
    _, faults = form.read("VERSION 1.3\n" + body)
    refused = {fault.reason.args["keyword"] for fault in faults if fault.reason.key == "files.version_for_line"}
    refused |= {"PICT"} if any(fault.reason.key == "files.version_for_picture" for fault in faults) else set()
    assert needed <= refused
    assert bool(faults) == bool(needed)
    assert form.read("VERSION 2.0\n" + body) == form.read(text)


@given(before=tasks(), after=tasks(), data=st.data())
@settings(max_examples=examples(100), deadline=None)
def test_a_changed_task_keeps_the_comments_of_its_file(before: Task, after: Task, data: st.DataObject) -> None:
    lines = rmod.write(RmodText(before)).splitlines()  # R-B01
    for number in range(3):
        lines.insert(data.draw(st.integers(0, len(lines))), f"# comment {number}")
    text = "\n".join(lines) + "\n"
    record, _ = rmod.read(text, "t", "f")
    assert record and rmod.write(record) == text
    changed = rmod.write(record, after)
    again, faults = rmod.read(changed, "t", "f")
    assert faults == ()
    assert again and (again.task, again.task.gives_period) == (after, after.gives_period)
    assert sorted(line for line in changed.splitlines() if line.startswith("#")) == sorted(
        line for line in lines if line.startswith("#")
    )
