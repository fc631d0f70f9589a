import pytest
from hypothesis import given, strategies as st

from onika.files.kept import read, write
from onika.model.kept import Demand, KeptAction, KeptFlow, KeptMeeting, KeptRun

DEMANDS = (Demand("LAMP", (1.0,)), Demand("GRIP_MEZ[0]", (0.112,), "m", 0.002), Demand("Q", (0.5, -1.2), "rad", 0.005))
KEPT = KeptRun(
    application="assemble",
    digest="16ef2d5dad66c466",
    flows=(
        KeptFlow(
            "flow0",
            (("puma", "boxes:arm_left"),),
            (KeptAction("jmoveC box2_aj", 2.3, 0.05, DEMANDS, is_on_way=True), KeptAction("opengripC", 0.18, 0.05)),
            DEMANDS[:1],
        ),
        KeptFlow("flow1"),
    ),
    meetings=(KeptMeeting("triangle", ("flow0", "flow1")),),
    seed=3,
    answers=(("wait", "duration", "0.5"), ("aim", "place", "1 2")),
    expectations=("LAMP == 1",),
    redirects=("puma=scara", "1:gripper=gripper_right"),
)
TEXT = write(KEPT)


def sentences(text):
    result, faults = read(text, "t", "t.test")
    assert result is None
    return [f"{fault.place.line}: {fault.reason}" for fault in faults]


def test_a_kept_run_is_read_as_it_was_written():  # R-X07
    assert read(TEXT, "t", "t.test") == (KEPT, ())


def test_a_person_can_read_it():  # R-X07
    assert "ACTION      jmoveC box2_aj\nLASTS       2.3 s +- 0.05\nONTHEWAY    yes\n" in TEXT
    assert "AFTER       LAMP 1\nAFTER       GRIP_MEZ[0] 0.112 m +- 0.002\n" in TEXT
    assert "MEET        triangle flow0 flow1\n" in TEXT


def test_comments_of_the_former_text_stay():  # R-B01, R-X07
    former = TEXT.replace("ACTION      opengripC", "# the hand must be empty here\nACTION      opengripC")
    assert "# the hand must be empty here\nACTION      opengripC" in write(KEPT, former)


def test_units_and_tolerances_may_be_left_out_and_written_as_people_do():  # R-X07
    text = TEXT.replace("0.112 m +- 0.002", "0.112 m ± 0.002").replace("2.3 s +- 0.05", "2.3")
    result, faults = read(text, "t", "t.test")
    assert faults == ()
    first = result.flows[0].actions[0]
    assert (first.lasts_s, first.within_s, first.after[1]) == (2.3, 0.0, DEMANDS[1])


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("GRIP_MEZ[0] 0.112 m", "GRIP_MEZ[0] m", "a variable, its values, their unit and +- a number after AFTER"),
        ("0.112 m +- 0.002", "0.112 m +- wide", "a variable, its values, their unit and +- a number after AFTER"),
        ("0.112 m +- 0.002", "0.112 m +- -1", "a variable, its values, their unit and +- a number after AFTER"),
        ("0.112 m", "1e999 m", "a variable, its values, their unit and +- a number after AFTER"),
        ("2.3 s", "2.3 min", "seconds and, where it matters, +- a number after LASTS"),
        ("2.3 s", "-1 s", "seconds and, where it matters, +- a number after LASTS"),
        ("ACTION      opengripC", "ACTION", "the name of an action after ACTION"),
        ("ROBOT       puma boxes:arm_left", "ROBOT puma", "a hardware task and its device after ROBOT"),
        ("EXPECT      LAMP == 1", "EXPECT LAMP = 1", "a condition such as LAMP == 1 after EXPECT"),
        ("REDIRECT    puma=scara", "REDIRECT puma", "[FLOW:]TASK=TASK or [FLOW:]WORLD:=WORLD: after REDIRECT"),
        ("ANSWER      wait duration 0.5", "ANSWER wait", "a task, the name of an input and its values after ANSWER"),
        ("MEET        triangle flow0 flow1", "MEET triangle", "a tag and the flows that met there after MEET"),
        ("END\nAFTER       LAMP 1\n", "", "END of the flow before"),
        ("FLOW        flow0", "", "a line FLOW before ACTION"),
        ("VERSION     2.0", "VERSION 9", "a file of version 1.3 or older, or 2.0"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(old, new, expected):  # R-B07, R-X07
    assert old in TEXT
    assert any(expected in item for item in sentences(TEXT.replace(old, new, 1)))


def test_a_text_without_a_flow_or_its_end_is_no_test():  # R-B07
    assert any("at least one FLOW" in item for item in sentences("VERSION 2.0\nAPPLICATION a\nEOF\n"))
    assert any("END of the last flow" in item for item in sentences("VERSION 2.0\nAPPLICATION a\nFLOW flow0\nEOF\n"))


@given(st.text(max_size=200))
def test_no_text_is_too_strange_to_be_read(text):  # R-B07
    result, faults = read(text, "t", "t.test")
    assert result is None
    assert faults
