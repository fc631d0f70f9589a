"""Processes of a class that are forked: that one answers, and what becomes of one that does not."""

import asyncio
import socket

import msgspec
import pytest

from onika.classroom import forks
from onika.classroom.forks import ForkedGrader
from onika.classroom.grading import Grading
from onika.classroom.roster import Grade, GradedExpectation

WANTED = Grading(("LAMP == 1",))


class Process:
    """A process that is none, and is ended."""

    pid, is_over = 1, False

    def kill(self):
        self.is_over = True

    def join(self, timeout=None):
        assert self.is_over


def grade(tmp_path, says, grading=WANTED):
    """The grade where the process says this; None: it says nothing and stays."""
    kept = []

    def begins(target, given, number, folder, scratch, theirs):
        if says is None:
            kept.append(socket.fromfd(theirs.fileno(), socket.AF_UNIX, socket.SOCK_STREAM))
        else:
            theirs.sendall(says)
        return Process()

    made = asyncio.run(ForkedGrader(grading, tmp_path, begins).grade(3, tmp_path))
    for each in kept:
        each.close()
    return made


def test_a_grade_is_what_the_process_says(tmp_path):  # R-X25
    told = Grade(3, (GradedExpectation("LAMP == 1", holds=True),))
    assert grade(tmp_path, msgspec.json.encode(told)) == told


def test_where_nothing_is_expected_nothing_is_run(tmp_path):
    assert grade(tmp_path, b"", Grading()) is None


@pytest.mark.parametrize("says", [b"", b"?", b'{"number":"x"}'])
def test_one_that_ends_without_a_grade_grades_nothing(tmp_path, says):
    assert grade(tmp_path, says).why.key == "class.grading_broken"


def test_one_that_takes_too_long_is_ended(tmp_path, monkeypatch):  # R-X25
    monkeypatch.setattr(forks, "LIMIT_S", 0.01)
    assert grade(tmp_path, None).why.key == "class.grading_long"
