import pytest

from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.desk.run.steering_script import load, read, steps
from onika.wire import steer
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

CAST = FlowIndex((IndexedFlow("flow0", ("lift", "turn"), frozenset()),))


def test_lines_stand_with_their_places_and_comments_are_left_out():  # R-E07
    script_lines, faults = read("# first\npause   # now\n\nskip 2\n", "s", CAST)
    assert faults == []
    assert [(script_line.place, script_line.text) for script_line in script_lines] == [
        (Place("s", 2), "pause"),
        (Place("s", 4), "skip 2"),
    ]
    assert script_lines[1].act.message == steer.Skip("flow0", 1)


def test_all_faults_are_told_with_their_lines():  # R-E07
    script_lines, faults = read("dance\npause\nskip 7\n", "s", CAST)
    assert [script_line.text for script_line in script_lines] == ["pause"]
    assert [fault.place for fault in faults] == [Place("s", 1), Place("s", 3)]
    unknown = Reason.of("desk.action_range", subsystem="flow0", count=2, word="7")
    assert faults[1] == Fault(Place("s", 3), unknown, Reason.of("words.nothing_run"))


def test_a_file_is_read_or_its_fault_is_told(tmp_path):  # R-E07
    path = tmp_path / "s"
    path.write_text("pause\n")
    assert [line.text for line in load(path, CAST)[0]] == ["pause"]
    script_lines, faults = load(tmp_path / "none", CAST)
    assert (script_lines, len(faults)) == ((), 1)


def test_a_stroke_is_many_pushes_between_two_times_of_letting_go():  # R-K07
    assert steps("pad 0 0 -1 for 0.1") == (("pad free", "wait 0.05") + ("pad 0 0 -1", "wait 0.05") * 2 + ("pad free",))
    assert len(steps("pad 0 0 -1 for 0.3")) == 2 + 2 * 6 + 1


def test_a_press_ends_by_itself():
    assert steps("pad press for 0.1") == ("pad press", "wait 0.05") * 2


@pytest.mark.parametrize(
    "line", ["pad 0 0 1", "wait 3", "pad free", "pad 0 0 1 for x", "pad 0 0 1 for -1", "pad 1 1 1 for nan", ""]
)
def test_any_other_line_is_itself(line):
    assert steps(line) == (line,)
