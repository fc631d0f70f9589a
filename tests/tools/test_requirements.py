"""The states of the requirements are held against the marks of the tests."""

import pytest

import requirements

MARK = "# R" + "-A01"
"""Put together here, so that this file bears no mark itself."""


@pytest.fixture
def house(tmp_path):
    """Writes a small repository: the state of one requirement, and its tests."""

    def write(state, **tests):
        page = (
            f"| id | requirement | source | state |\n|---|---|---|---|\n| A01 | A module is a class. | §3 | {state} |\n"
        )
        for name, text in {requirements.PAGE: page, **tests}.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text)
        return tmp_path

    return write


def check(root):
    return requirements.main(["--check", "--root", str(root)])


@pytest.mark.parametrize("state", ["works: `tests/test_a.py`", "in part: it is slow"])
def test_a_state_that_its_tests_bear_out_is_in_order(house, state):
    assert check(house(state, **{"tests/test_a.py": MARK})) == 0


def test_a_row_that_works_needs_the_mark_in_the_file_it_names(house, capsys):
    assert check(house("works: `tests/test_a.py`", **{"tests/test_b.py": MARK})) == 1
    assert "tests/test_a.py bears no mark" in capsys.readouterr().out


def test_a_mark_of_the_page_counts_too(house):
    assert check(house("works: `browser/test/a.test.ts`", **{"browser/test/a.test.ts": f"/{MARK}"})) == 0


def test_a_row_that_is_not_there_may_have_no_mark(house, capsys):
    assert check(house("not there")) == 0
    assert check(house("not there", **{"tests/test_a.py": MARK})) == 1
    assert "A01 is not there" in capsys.readouterr().out


def test_a_mark_without_a_row_is_named(house, capsys):
    assert check(house("not there", **{"tests/test_a.py": MARK.replace("A01", "Z99")})) == 1
    assert "tests/test_a.py bears the mark" in capsys.readouterr().out


@pytest.mark.parametrize("state", ["", "works", "in part:", "planned"])
def test_a_row_without_a_state_is_named(house, state, capsys):
    assert check(house(state)) == 1
    assert "A01 has no state" in capsys.readouterr().out


def test_a_test_that_was_moved_is_found_again(house):
    root = house("works: `tests/test_a.py`", **{"tests/test_b.py": MARK, "tests/test_c.py": f"{MARK}\n{MARK}"})
    assert requirements.main(["--root", str(root)]) == 0
    assert "works: `tests/test_c.py`" in (root / requirements.PAGE).read_text()
    assert check(root) == 0


def test_the_requirements_of_this_repository_are_true():
    assert check(requirements.ROOT) == 0
