"""Every text means to us what it means to a second, naive reader of Appendix A that shares no code with ours.

This is what "no wrong load" is: of any text, damaged in any way, we either tell a fault or read what the naive reader
reads; and a text that the naive reader finds right is without fault for us.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st
from tests.contract.test_formats import every_format
from tests.files.independent.judge import naive_readers, plain
from tests.files.models import FORMATS, TYPES, Format

from kit.examples import examples
from onika.model.configuration import Configuration, Placed
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

NAIVE = naive_readers(TYPES)
REFUSED = object()
LAYOUT = [" ", "  ", "\t", " \t "]


def naive(form: Format, text: str) -> object:
    """What the naive reader finds, or REFUSED."""
    try:
        return NAIVE[form.name](text)
    except ValueError:
        return REFUSED


def judge(form: Format, text: str) -> None:
    """Ours and the naive reading agree; where ours tells a note, it may read what the other refuses."""
    model, faults = form.read(text)
    is_right = not any(not fault.is_note for fault in faults)
    other = naive(form, text)
    if is_right and (other is not REFUSED or not faults):
        assert plain(model) == other, text
    if other is not REFUSED:
        assert is_right, (faults, text)


@every_format
@given(data=st.data())
@settings(max_examples=examples(40), deadline=None)
def test_what_we_write_says_the_same_to_the_other_reader(form: Format, data: st.DataObject) -> None:
    model = data.draw(form.models)  # R-B01, R-B02, R-B03, R-B04, R-B05
    assert naive(form, form.write(model)) == plain(model)


@every_format
@given(data=st.data())
@settings(max_examples=examples(40), deadline=None)
def test_any_layout_says_the_same_to_both(form: Format, data: st.DataObject) -> None:
    model = data.draw(form.models)  # R-B01
    text = form.write(model)
    if form.name != "picture":
        text = text.replace("      ", data.draw(st.sampled_from(LAYOUT)) + "     ").replace("\nEOF", "\n \t# x\n\tEOF ")
    text = text.replace("\n", data.draw(st.sampled_from(["\n", "\r\n"])))
    assert naive(form, text) == plain(model)
    judge(form, text)


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_a_file_cut_before_any_line_is_read_alike(form: Format, data: st.DataObject) -> None:
    lines = form.write(data.draw(form.models)).splitlines(keepends=True)  # R-B07
    for end in range(len(lines)):
        judge(form, "".join(lines[:end]))
        judge(form, "".join(lines[:end]) + "EOF\n")


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_a_file_with_any_line_lost_or_doubled_is_read_alike(form: Format, data: st.DataObject) -> None:
    lines = form.write(data.draw(form.models)).splitlines(keepends=True)  # R-B07
    for at, line in enumerate(lines):
        judge(form, "".join([*lines[:at], *lines[at + 1 :]]))
        judge(form, "".join([*lines[:at], line, *lines[at:]]))


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_a_file_with_two_neighbours_exchanged_anywhere_is_read_alike(form: Format, data: st.DataObject) -> None:
    lines = [line for line in form.write(data.draw(form.models)).splitlines(keepends=True) if line.strip()]  # R-B07
    for at in range(len(lines) - 1):
        judge(form, "".join([*lines[:at], lines[at + 1], lines[at], *lines[at + 2 :]]))


@every_format
@given(data=st.data())
@settings(max_examples=examples(30), deadline=None)
def test_a_file_with_signs_changed_in_any_line_is_read_alike(form: Format, data: st.DataObject) -> None:
    lines = form.write(data.draw(form.models)).splitlines(keepends=True)  # R-B07
    for at, line in enumerate(lines):
        place = data.draw(st.integers(0, len(line) - 1))
        sign = data.draw(st.sampled_from(["", "#", "9", "-", ".", "x", "X", " ", '"', "=", "\n", "\t", "\\", "none"]))
        judge(form, "".join([*lines[:at], line[:place] + sign + line[place + 1 :], *lines[at + 1 :]]))


@every_format
@given(data=st.data())
@settings(max_examples=examples(60), deadline=None)
def test_lines_of_two_files_in_any_order_are_read_alike(form: Format, data: st.DataObject) -> None:
    lines = [line for _ in range(2) for line in form.write(data.draw(form.models)).splitlines(keepends=True)]  # R-B07
    judge(form, "".join(data.draw(st.lists(st.sampled_from(lines), max_size=12))) + "EOF\n")


@pytest.mark.parametrize(
    "version", [None, "1", "1.2", "1.2.9", "01.3", "1.3.0", "1.3.1", "1.4", "2", "2.0", "2.1", "x", ""]
)
@every_format
@given(data=st.data())
@settings(max_examples=5, deadline=None)
def test_files_of_any_version_are_read_alike(form: Format, version: str | None, data: st.DataObject) -> None:
    text = form.write(data.draw(form.models))  # R-B06
    if text.startswith("VERSION"):
        text = ("" if version is None else f"VERSION     {version}\n") + text.partition("\n")[2]
    judge(form, text)
    lacking = ("INLEFT", "FREQ", "RTPU", "CONNS", "NUM", "SHOW", "DESC", "MARKER", "APPLTYPE", "SPAWN")
    judge(form, "".join(line for line in text.splitlines(keepends=True) if not line.startswith(lacking)))


def _mirrored(form: Format) -> Format:
    """A reader with a mistake: x and y of every task exchanged."""

    def read(text: str) -> tuple[Any, tuple[Fault, ...]]:
        record, faults = form.read(text)
        return record and replace(record, placed=tuple(replace(p, x=p.y, y=p.x) for p in record.placed)), faults

    return replace(form, read=read)


def _lenient(form: Format) -> Format:
    """A reader with a mistake: it reads what it can and tells nothing."""
    return replace(form, read=lambda text: (form.read(text)[0], ()))


def _strict(form: Format) -> Format:
    """A reader with a mistake: it finds a fault in everything."""
    return replace(
        form, read=lambda _text: (None, (Fault(Place("f"), Reason.plain("expected , found "), Reason.plain("")),))
    )


@pytest.mark.parametrize("mistake", [_mirrored, _lenient, _strict])
@given(data=st.data())
@settings(max_examples=5, deadline=None)
def test_a_mistake_of_ours_would_be_found(mistake: Callable[[Format], Format], data: st.DataObject) -> None:
    form = mistake(next(form for form in FORMATS if form.name == "configuration"))
    text = form.write(Configuration("c", (Placed("a", data.draw(st.integers(1, 99)), 0),)))
    with pytest.raises(AssertionError):
        for damaged in (text, text.replace("EOF", "")):
            judge(form, damaged)
