import runpy
from pathlib import Path

import pytest

TOOL = Path(__file__).parents[2] / "tools" / "check_mirror.py"


@pytest.fixture
def house(tmp_path):
    """A small house in which every source has its test."""
    for name in (
        "src/onika/__init__.py",
        "src/onika/__main__.py",
        "src/onika/model/task.py",
        "src/onika/labs/puma/module/puma.py",
        "tests/test_main.py",
        "tests/model/test_task.py",
        "tests/play/test_run.py",
        "tests/model/sample.py",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    return tmp_path


@pytest.fixture
def tool():
    """The names of the tool; its functions see these very tables."""
    return runpy.run_path(str(TOOL))


def complaints(tool, house):
    return list(tool["complaints"](house))


def test_a_house_whose_tests_mirror_it_is_in_order(tool, house):
    assert complaints(tool, house) == []


def test_a_source_without_its_test_is_named(tool, house):
    (house / "src/onika/model/port.py").touch()
    assert complaints(tool, house) == ["src/onika/model/port.py has no tests/model/test_port.py"]


def test_a_test_without_its_source_is_named(tool, house):
    (house / "src/onika/model/task.py").unlink()
    assert complaints(tool, house) == ["tests/model/test_task.py tests no src/onika/model/task.py"]


def test_what_is_said_of_one_source_may_stand_apart_by_subject(tool, house):
    (house / "tests/model/test_task_ports.py").touch()
    assert complaints(tool, house) == []


def test_a_subject_does_not_stand_in_for_the_test_of_its_source(tool, house):
    (house / "tests/model/test_task.py").rename(house / "tests/model/test_task_ports.py")
    assert complaints(tool, house) == ["src/onika/model/task.py has no tests/model/test_task.py"]


def test_an_exception_stands_only_while_it_is_needed(tool, house):
    (house / "src/onika/model/port.py").touch()
    tool["complaints"].__globals__["WITHOUT_TEST"] |= {"model/port.py": "why", "model/task.py": "why", "gone.py": "why"}
    assert complaints(tool, house) == [
        "src/onika/model/task.py has its test: strike it from WITHOUT_TEST",
        "src/onika/gone.py is gone: strike it from WITHOUT_TEST",
    ]


def test_the_answer_to_the_shell_says_whether_there_is_a_complaint(tool, house, capsys):
    assert tool["main"](house) == 0
    (house / "src/onika/model/port.py").touch()
    assert tool["main"](house) == 1
    assert capsys.readouterr().out.startswith("src/onika/model/port.py")


def test_what_is_tested_as_one_needs_no_test_of_each_file(tool, house):
    (house / "src/onika/wire").mkdir()
    (house / "src/onika/wire/steer.py").touch()
    assert complaints(tool, house) == []


def test_what_is_tested_as_one_may_have_a_test_of_a_file_but_none_of_no_file(tool, house):
    for name in ("src/onika/wire/frame.py", "tests/wire/test_frame.py", "tests/wire/test_gone.py"):
        (house / name).parent.mkdir(exist_ok=True)
        (house / name).touch()
    assert complaints(tool, house) == ["tests/wire/test_gone.py tests no src/onika/wire/gone.py"]
