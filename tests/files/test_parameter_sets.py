"""The file of parameter sets: what is written is read again, and damage is told."""

import pytest
from hypothesis import given, settings, strategies as st
from tests.files.models import names, some_prose, words

from kit.examples import examples
from onika.files.parameter_sets import read, write
from onika.model.parameter_set import ParameterSet
from onika.model.task import LocalLine

keys = st.from_regex(r"[A-Z][A-Z0-9_]{0,5}", fullmatch=True)
values = st.dictionaries(st.tuples(names, keys), st.lists(words, max_size=3).map(tuple), max_size=4).map(
    lambda lines: tuple((task, LocalLine(key, given)) for (task, key), given in lines.items())
)
sets = st.dictionaries(some_prose, values, max_size=3).map(
    lambda by_name: tuple(ParameterSet(name, held) for name, held in by_name.items())
)


@given(sets)
@settings(max_examples=examples(50), deadline=None)
def test_what_is_written_is_read_again_as_the_same_sets_and_the_same_bytes(given_sets):  # R-B08
    text = write(given_sets)
    assert read(text, "move", "f") == (given_sets, ())
    assert write(read(text, "move", "f")[0], text) == text


@given(sets, st.data())
@settings(max_examples=examples(30), deadline=None)
def test_a_file_that_is_cut_is_reported(given_sets, data):  # R-B07
    lines = write(given_sets).splitlines(keepends=True)
    end = data.draw(st.integers(0, len(lines) - 1))
    found, faults = read("".join(lines[:end]), "move", "f")
    assert found is None
    assert faults


@given(st.text(max_size=200))
@settings(max_examples=examples(50), deadline=None)
def test_no_text_at_all_raises(text):  # R-B07
    found, faults = read(text, "move", "f")
    assert faults or found is not None


@pytest.mark.parametrize(
    ("body", "line", "key"),
    [
        ("SET soft\nLOCAL pd\n", 3, "files.parameter_of_task"),
        ("SET soft\nLOCAL 9d STIFF 1\n", 3, "files.parameter_of_task"),
        ("SET soft\nLOCAL pd STIFF 1\nLOCAL pd STIFF 2\n", 4, "files.every_name_once"),
        ("SET soft\nSET soft\n", 3, "files.every_name_once"),
        ("SET\n", 2, "files.text_after"),
        ("LOCAL pd STIFF 1\n", 2, "files.no_more_lines"),
        ("SET soft\nxyz\n", 3, "files.keywords_expected"),
    ],
)
def test_what_is_no_set_is_named_with_its_line(body, line, key):  # R-B07
    found, faults = read(f"VERSION 2.0\n{body}EOF\n", "move", "f")
    assert found is None
    assert (line, key) in [(fault.place.line, fault.reason.key) for fault in faults]


def test_comments_stay_where_they_are():  # R-B01
    text = "VERSION 2.0\n\n# of Monday\nSET soft\nLOCAL pd STIFF 0.5\n\nEOF\n"
    (soft,), _ = read(text, "move", "f")
    hard = ParameterSet("hard", (("pd", LocalLine("STIFF", ("2",))),))
    assert "# of Monday\nSET soft" in write((soft, hard), text)
