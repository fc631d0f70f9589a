import string

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.files.puzzles.puzzle import read, write
from onika.model.puzzle import GoalWords, Puzzle

PUZZLE = Puzzle(
    name="light",
    titles=(("en", "Light"), ("es", "Luz")),
    tasks=(("en", "Light the lamp."), ("es", "Encienda la lámpara.")),
    expectations=("LAMP == 1", "GRIP_MEZ[0] > 0.1"),
    level=3,
    program="dark.al",
    actions=25,
    seconds=23.5,
    hints=((("en", "Open first."), ("es", "Abra primero.")), (("en", "Then go down."),)),
    solution="assemble",
    goals=(GoalWords(2, (("en", "the lamp is lit"), ("es", "la lámpara está encendida"))),),
)
TEXT = write(PUZZLE)


def sentences(text):
    puzzle, faults = read(text, "light", "light.puzzle")
    assert puzzle is None
    return [f"{fault.place.line}: {fault.reason}" for fault in faults]


def test_a_puzzle_is_read_as_it_was_written():  # R-G10
    assert read(TEXT, "light", "f") == (PUZZLE, ())


def test_a_person_can_read_it():  # R-G10
    assert "TITLE       en Light\nTITLE       es Luz\nTASK        en Light the lamp.\n" in TEXT
    assert (
        "EXPECT      LAMP == 1\nEXPECT      GRIP_MEZ[0] > 0.1\nGOAL        2 en the lamp is lit\n"
        "GOAL        2 es la lámpara está encendida\nACTIONS     25\nSECONDS     23.5\n" in TEXT
    )


def test_what_is_needed_is_little():  # R-G10
    text = "VERSION 2.0\nTITLE en A\nTASK en B\nLEVEL 1\nEXPECT LAMP == 1\nEOF\n"
    assert read(text, "a", "f") == (Puzzle("a", (("en", "A"),), (("en", "B"),), ("LAMP == 1",)), ())


def test_comments_of_the_former_text_stay():  # R-G10
    former = TEXT.replace("LEVEL", "# not too hard\nLEVEL")
    assert "# not too hard\nLEVEL" in write(PUZZLE, former)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("EXPECT      LAMP == 1\n", "EXPECT      LAMP is on\n", "10: expected a condition such as LAMP == 1"),
        ("LEVEL       3", "LEVEL       10", "7: expected a whole number from 1 to 9 after LEVEL"),
        ("LEVEL       3", "LEVEL       two", "7: expected a whole number from 1 to 9 after LEVEL"),
        ("ACTIONS     25", "ACTIONS     0", "14: expected a whole number from 1 to 10000 after ACTIONS"),
        ("SECONDS     23.5", "SECONDS     nan", "15: expected seconds, more than 0 and at most 3600 after SECONDS"),
        ("SECONDS     23.5", "SECONDS     -1", "15: expected seconds, more than 0 and at most 3600 after SECONDS"),
        ("TITLE       es Luz", "TITLE       fr Lumière", "4: expected a language of en and es, each once"),
        ("TITLE       es Luz", "TITLE       en Luz", "4: expected a language of en and es, each once"),
        ("HINT        es Abra", "HINT        fr Abra", "18: expected a language of en and es, each once in a hint"),
        ("GOAL        2 en", "GOAL        3 en", "12: expected how many conditions are meant, no more than there are"),
        ("GOAL        2 en", "GOAL        0 en", "12: expected how many conditions are meant"),
        ("GOAL        2 en", "GOAL        two en", "12: expected how many conditions are meant"),
        ("GOAL        2 es", "GOAL        1 es", "13: expected how many conditions are meant"),
        ("GOAL        2 es", "GOAL        2 fr", "13: expected how many conditions are meant"),
        ("GOAL        2 es", "GOAL        1 en", "13: expected how many conditions are meant"),
        ("PROGRAM     dark.al", "PROGRAM     dark one.al", "8: expected the name of an application, or of a text"),
        ("TASK        en Light the lamp.\nTASK        es Encienda la lámpara.\n", "", "expected a line TASK"),
        ("EXPECT      LAMP == 1\nEXPECT      GRIP_MEZ[0] > 0.1\n", "", "expected a line EXPECT"),
        ("VERSION     2.0", "VERSION     2.1", "1: expected a file of version 1.3"),
        ("VERSION     2.0", "VERSION     3", "1: expected"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(old, new, expected):  # R-B07, R-G10
    assert old in TEXT
    assert any(expected in sentence for sentence in sentences(TEXT.replace(old, new, 1))), sentences(
        TEXT.replace(old, new, 1)
    )


def test_a_file_cut_at_any_line_is_reported():  # R-B07
    lines = TEXT.splitlines(keepends=True)
    for end in range(len(lines)):
        assert read("".join(lines[:end]), "light", "f")[1], f"cut before line {end + 1}"


WORDS = st.text(string.ascii_letters + " éñ,.", min_size=1, max_size=20).map(lambda text: " ".join(text.split()) or "x")
NAMES = st.one_of(
    st.tuples(st.tuples(st.just("en"), WORDS)),
    st.tuples(st.tuples(st.just("en"), WORDS), st.tuples(st.just("es"), WORDS)),
)
PROGRAMS = st.sampled_from(["", "assemble", "dark.al"])
PUZZLES = st.builds(
    Puzzle,
    name=st.just("light"),
    titles=NAMES,
    tasks=NAMES,
    expectations=st.lists(st.sampled_from(["LAMP == 1", "flow0/Q_MEZ[2] > 1.5"]), min_size=1, max_size=3).map(tuple),
    level=st.integers(1, 9),
    program=PROGRAMS,
    actions=st.integers(0, 10_000),
    seconds=st.one_of(st.just(0.0), st.floats(0.001, 3600.0)),
    hints=st.lists(NAMES, max_size=3).map(tuple),
    solution=PROGRAMS,
    goals=st.lists(st.builds(GoalWords, st.just(1), NAMES), max_size=1).map(tuple),
)


@given(puzzle=PUZZLES)
@settings(max_examples=examples(30), deadline=None)
def test_any_puzzle_is_read_as_it_was_written(puzzle):  # R-G10
    assert read(write(puzzle), "light", "f") == (puzzle, ())


@given(text=st.text(max_size=200))
def test_no_text_makes_the_reader_fail(text):  # R-B07
    puzzle, faults = read(text, "light", "f")
    assert puzzle is None and faults
