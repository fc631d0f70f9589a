import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from kit.examples import examples
from kit.record.recording_builder import RecordingBuilder, run
from onika.record.difference import first_difference
from onika.record.reader import Reader
from onika.record.tolerance import WALL, Tolerance
from onika.wire import event
from onika.wire.figures import VariableSteps
from onika.words.reason import NOTHING

COURSE = ((0.0, [0.0, 0.0]), (1.0, [1.0, 2.0]), (2.0, [3.0, 4.0]))


def tape(tmp_path, name, course=COURSE, began_s=0.5, action="go", of=2):
    recording = RecordingBuilder(tmp_path / f"{name}.mcap")
    recording.variable("X", "double[2]", *course)
    recording.tell(began_s, event.Began(0, 0, of, action, began_s))
    return recording.end()


def difference(tmp_path, tolerance=None, **other):
    return first_difference(tape(tmp_path, "a"), tape(tmp_path, "b", **other), tolerance or Tolerance())


def test_equal_runs_do_not_differ(tmp_path):  # R-X05
    assert difference(tmp_path) is None


def by_hand(tmp_path, name, home, *variables):
    """A recording of a subsystem that was held by hand."""
    made = RecordingBuilder(tmp_path / f"{name}.mcap", run(is_by_hand=True))
    made.tell(0.0, event.TaskState(home, name, "ON", 0.0), home)
    for variable, course in variables:
        made.variable(variable, "double", *course, unit="rad", home=home)
    return made.end(completed="yes")


def test_two_controllers_by_hand_are_compared_in_the_variables_that_both_have(tmp_path):  # R-X05
    first = by_hand(tmp_path, "pd", "left", ("Q", ((0.0, 0.0), (1.0, 1.0), (2.0, 2.0))), ("GAIN", ((0.0, 5.0),)))
    same = by_hand(tmp_path, "pid", "right", ("Q", ((0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 9.0))))
    assert first_difference(first, same, Tolerance()) is None
    other = by_hand(tmp_path, "slow", "right", ("Q", ((0.0, 0.0), (1.0, 1.5), (2.0, 2.0))))
    found = first_difference(first, other, Tolerance())
    assert (found.at_ns, found.variable, str(found.what)) == (1_000_000_000, "left/Q", "left/Q")
    strange = by_hand(tmp_path, "strange", "right", ("P", ((0.0, 0.0),)))
    assert first_difference(first, strange, Tolerance()).what.key == "record.the_variables"


def test_how_many_actions_are_to_come_is_no_difference_of_the_one_that_begins(tmp_path):  # R-X05
    assert difference(tmp_path, of=3) is None


def test_the_first_value_that_is_another_is_told_with_its_element(tmp_path):  # R-X05
    difference_ = difference(tmp_path, course=((0.0, [0.0, 0.0]), (1.0, [1.0, 2.5]), (2.0, [9.0, 9.0])))
    assert str(difference_.sentence) == "at 1 s: flow0/X[1]: 2.0, in the other 2.5"


@pytest.mark.parametrize(
    ("tolerance", "differs"), [(Tolerance(0.5), False), (Tolerance(part=0.25), False), (Tolerance(0.49), True)]
)
def test_values_within_the_tolerance_are_the_same(tmp_path, tolerance, differs):  # R-X05
    other = ((0.0, [0.0, 0.0]), (1.0, [1.0, 2.5]), (2.0, [3.0, 4.0]))
    assert (difference(tmp_path, tolerance, course=other) is not None) == differs


def test_the_same_course_a_little_later_is_within_a_tolerance_of_time(tmp_path):  # R-X05
    later = tuple((at + 0.01 if at else at, values) for at, values in COURSE)
    assert difference(tmp_path, course=later).at_ns == 1_000_000_000
    assert difference(tmp_path, Tolerance(seconds=0.011), course=later) is None


def test_an_event_that_is_another_or_later_is_told(tmp_path):  # R-X05
    assert "action go" in str(difference(tmp_path, action="stay").first)
    assert difference(tmp_path, began_s=0.75).what.text == "flow0"
    assert difference(tmp_path, Tolerance(seconds=0.25), began_s=0.75) is None


def test_what_only_one_of_them_has_is_told(tmp_path):  # R-X05
    other = RecordingBuilder(tmp_path / "b.mcap")
    other.variable("X", "double[2]", *COURSE)
    difference = first_difference(tape(tmp_path, "a"), other.end(), Tolerance())
    assert (difference.at_ns, str(difference.second)) == (500_000_000, "nothing more")
    less = RecordingBuilder(tmp_path / "c.mcap").end()
    assert str(first_difference(tape(tmp_path, "a"), less, Tolerance()).first) == "it is there"


@given(k=st.integers(0, 2), by=st.floats(0.1, 5.0), place=st.integers(0, 1))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(30))
def test_whatever_value_is_changed_is_the_first_difference(tmp_path, k, by, place):  # R-X05
    other = [(at, list(values)) for at, values in COURSE]
    other[k][1][place] += by
    difference_ = difference(tmp_path, Tolerance(0.05), course=other)
    assert (difference_.at_ns, str(difference_.what)) == (k * 1_000_000_000, f"flow0/X[{place}]")


def test_a_difference_late_in_long_runs_is_found_and_one_that_nobody_wants_is_not_looked_for(tmp_path):  # R-X05
    slow = [(float(k), [float(k), 0.0]) for k in range(95)]
    other = [(at, [first, 1.0 if at == 63.0 else two]) for at, (first, two) in slow]
    first, two = tape(tmp_path, "a", course=slow), tape(tmp_path, "b", course=other)
    difference_ = first_difference(first, two, Tolerance())
    assert (difference_.at_ns, str(difference_.what), difference_.variable) == (63_000_000_000, "flow0/X[1]", "flow0/X")
    assert first_difference(first, two, Tolerance(), lambda: False) is None


def test_a_run_cut_short_is_compared_as_far_as_it_goes(tmp_path):  # R-X05
    whole = tape(tmp_path, "a", course=(*COURSE, (9.0, [5.0, 6.0])))
    for course, differs in ((COURSE, False), ((COURSE[0], (1.0, [1.0, 3.0]), (1.2, [1.0, 3.5])), True)):
        tape(tmp_path, "b", course=course)
        path = tmp_path / "b.mcap"
        path.write_bytes(path.read_bytes()[:-9])
        cut = Reader(path)
        assert not cut.is_whole
        assert (first_difference(whole, cut, Tolerance()) is not None) == differs
        assert (first_difference(cut, whole, Tolerance()) is not None) == differs


def test_runs_in_wall_time_are_compared_by_places(tmp_path):  # R-X05
    def hand(name, place, speed, force):
        recording = RecordingBuilder(tmp_path / f"{name}.mcap")
        for at_s in (0.0, 1.0):
            recording.tell(at_s, event.Began(0, 0, 1, "go", at_s))
        recording.variable("GRIP", "double[3]", (0.0, [0.1, 0.0, 0.0]), (1.0, [place, speed, force]), unit="m,m/s,N")
        recording.variable("TAU", "double[2]", (0.0, [0.0, 0.0]), (1.0, [force, force]), unit="N m")
        return recording.end()

    first = hand("a", 0.2, 1.0, 60.0)
    assert first_difference(first, hand("b", 0.201, -3.0, -60.0), WALL) is None
    assert first_difference(first, hand("c", 0.21, 1.0, 60.0), WALL).what.text == "flow0/GRIP[0]"
    assert first_difference(first, hand("d", 0.2, 1.0, -60.0), Tolerance(0.1)).what.text == "flow0/GRIP[2]"


def test_the_steps_that_a_run_measured_at_its_end_are_no_difference_by_themselves(tmp_path):  # R-X05: told by values
    def ended(name, step):
        recording = RecordingBuilder(tmp_path / f"{name}.mcap")
        steps = (VariableSteps("flow0", "puma", "TAU", "N m", 1, 0, step, step, 18.0, 0.5),)
        recording.tell(1.0, event.Result(True, NOTHING, 1, 1, 1.0, 1.0, {}, (), "", steps=steps), "")
        return recording.end()

    assert first_difference(ended("a", 1.0), ended("b", 1.1), Tolerance()) is None


def test_what_was_expected_of_a_run_is_no_difference(tmp_path):  # R-X05: only looked at, told by its variable
    def ended(name, values):
        recording = RecordingBuilder(tmp_path / f"{name}.mcap")
        recording.tell(1.0, event.Result(True, NOTHING, 1, 1, 1.0, 1.0, values, (), "abc"), "")
        return recording.end()

    assert first_difference(ended("a", {}), ended("b", {"X": [1.0]}), Tolerance()) is None


def boxed(tmp_path, name, values, *events, goes_on=False):
    """A black box of what happened from 2 s to 4 s."""
    recording = RecordingBuilder(tmp_path / f"{name}.mcap", held_s=(2.0, 4.0))
    recording.variable("X", "double[1]", *values)
    for at, action in events:
        recording.tell(at, event.Began(0, 0, 2, action, at))
    reader = recording.end()
    if goes_on:
        reader.notes["end"]["goes_on"] = "yes"
    return reader


def whole_run(tmp_path, *more):
    recording = RecordingBuilder(tmp_path / "whole.mcap")
    recording.variable("X", "double[1]", (0.0, [0.0]), (1.0, [1.0]), (3.0, [3.0]), *more)
    for at, action in ((0.5, "go"), (2.5, "stay")):
        recording.tell(at, event.Began(0, 0, 2, action, at))
    return recording.end()


def test_of_a_black_box_only_the_time_that_both_hold_is_compared(tmp_path):  # R-X05
    whole = whole_run(tmp_path)
    same = boxed(tmp_path, "same", [(2.0, [1.0]), (3.01, [3.0])], (2.0, "go"), (2.51, "stay"))
    assert first_difference(whole, same, Tolerance()) is None
    assert first_difference(same, whole, Tolerance()) is None
    other = boxed(tmp_path, "other", [(2.0, [1.0]), (3.0, [4.0])], (2.0, "go"), (2.5, "stay"))
    assert first_difference(whole, other, Tolerance()).at_ns == 3_000_000_000
    told = boxed(tmp_path, "told", [(2.0, [1.0]), (3.0, [3.0])], (2.0, "go"), (2.5, "leave"))
    assert "leave" in str(first_difference(whole, told, Tolerance()).second)


def test_what_came_after_a_fault_is_not_in_its_black_box_and_no_difference(tmp_path):  # R-X05
    whole = whole_run(tmp_path, (9.0, [9.0]))
    values, stay = [(2.0, [1.0]), (3.0, [3.0])], (2.5, "stay")
    assert first_difference(whole, boxed(tmp_path, "fault", values, stay, goes_on=True), Tolerance()) is None
    assert first_difference(whole, boxed(tmp_path, "end", values, stay), Tolerance()) is not None
