import os

import pytest

from onika.wire import live, request
from onika.words.reason import Reason


@pytest.fixture
def followed(sit, tmp_path):
    sitting = sit()
    path = tmp_path / "diff.py"
    path.write_text("# one\n")
    sitting.does("spawn diff", f"follow diff {path}")
    return sitting, path


def write(path, text, second):
    """A file as an editor leaves it; its time is said, so that no test depends on a clock."""
    path.write_text(text)
    os.utime(path, ns=(second * 10**9, second * 10**9))


def pass_a_second(sitting):
    start = len(sitting.lines)
    for _ in range(120):
        sitting.session.hear()
    return sitting.lines[start:]


def test_a_changed_file_is_the_tasks_new_code(followed):  # R-X15, R-A14
    sitting, path = followed
    assert pass_a_second(sitting) == []
    write(path, "# two\n", 1)
    assert any("runs the new code" in line for line in pass_a_second(sitting))
    assert [swap.code.source for swap in sitting.requests_of(live.Swap)] == ["# two\n"]
    pass_a_second(sitting)
    assert len(sitting.requests_of(live.Swap)) == 1


def test_a_file_that_was_only_touched_changes_nothing(followed):
    sitting, path = followed
    write(path, "# one\n", 7)
    assert pass_a_second(sitting) == []
    assert sitting.requests_of(live.Swap) == []


def test_code_with_faults_leaves_the_old_code_and_is_followed_on(followed):  # R-X15
    sitting, path = followed
    sitting.runtime.faults = (
        request.FaultText(
            "diff.py", 1, Reason.plain("expected a class, found none"), Reason.plain("it is not exchanged")
        ),
    )
    write(path, "# bad\n", 2)
    output = pass_a_second(sitting)
    assert any("diff.py:1: expected a class" in line for line in output)
    assert any("goes on with its old code" in line for line in output)
    sitting.runtime.faults = ()
    write(path, "# good\n", 3)
    assert any("runs the new code" in line for line in pass_a_second(sitting))


def test_code_that_finds_no_gap_between_cycles_is_tried_again_a_few_times(followed):  # R-X15
    sitting, path = followed
    former = sitting.runtime._carry_out
    outcomes = iter(["the largest gap is too small", "the largest gap is too small", ""])

    def carry_out(message):
        cause = next(outcomes)
        if cause:
            raise ValueError(cause)
        former(message)

    sitting.runtime._carry_out = carry_out
    write(path, "# two\n", 2)
    output = [line for _ in range(4) for line in pass_a_second(sitting)]
    assert sum("tried again in a second" in line for line in output) == 2
    assert any("runs the new code" in line for line in output)


def test_code_that_is_refused_again_and_again_is_given_up(followed):
    sitting, path = followed
    sitting.runtime.refusals["Swap"] = "held by ada"
    write(path, "# two\n", 2)
    for _ in range(10):
        pass_a_second(sitting)
    assert len(sitting.requests_of(live.Swap)) == 5
    assert sitting.lines[-1] == "main/diff goes on with its old code"


def test_a_file_that_is_gone_for_a_moment_is_waited_for(followed):
    sitting, path = followed
    path.unlink()
    assert pass_a_second(sitting) == []
    write(path, "# back\n", 4)
    pass_a_second(sitting)
    assert sitting.requests_of(live.Swap)[0].code.source == "# back\n"


def test_following_ends_with_the_task_or_when_it_is_told(followed):
    sitting, path = followed
    assert sitting.does("follow") == [f"main/diff follows {path}"]
    sitting.does("follow off diff")
    assert sitting.does("follow") == ["nothing is followed"]
    sitting.does(f"follow diff {path}", "kill diff")
    pass_a_second(sitting)
    assert any("lives no more" in line for line in sitting.lines)
    sitting.does("follow off")
    assert sitting.does("follow") == ["nothing is followed"]


def test_the_file_of_the_search_path_is_followed_unless_another_is_named(sit, tmp_path):
    sitting = sit()
    sitting.does("spawn diff")
    assert sitting.does("follow diff")[0].endswith("generic/module/diff.py")
    assert sitting.fails(f"follow diff {tmp_path}/none.py").reason == Reason.of(
        "console.code_file_missing", path=f"{tmp_path}/none.py"
    )
    assert sitting.fails("follow pd").reason == Reason.of(
        "console.not_living", subsystem="main", living=("diff",), name="pd"
    )
