"""A class name that several packages use has a reason."""

import pytest

import shared_names


@pytest.fixture
def house(tmp_path):
    """Writes a small repository in which two packages have a class `Stop`, with these rows of reasons."""

    def write(*rows):
        for package in ("engine", "wire"):
            (tmp_path / "src" / "onika" / package).mkdir(parents=True)
            (tmp_path / "src" / "onika" / package / "order.py").write_text("class Stop: ...\n")
        (tmp_path / "src" / "onika" / "engine" / "halt.py").write_text("class Stop: ...\nclass Halt: ...\n")
        (tmp_path / "pyproject.toml").write_text("\n".join(["[tool.onika.shared-names]", *rows]))
        return tmp_path

    return write


def test_a_name_that_two_packages_use_wants_a_reason(house):
    assert shared_names.unexplained(house()) == ["Stop in engine, wire"]


def test_a_name_with_a_reason_may_be_shared(house):
    assert shared_names.unexplained(house('"a command on its way" = ["Stop"]')) == []


def test_a_reason_without_a_shared_name_has_to_go(house):
    root = house('"a command on its way" = ["Stop", "Halt"]')
    assert shared_names.unexplained(root) == ["Halt has a reason and is not shared"]
