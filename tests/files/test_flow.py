import pytest

from onika.files.flow import DEEPEST, HEADS, depth, has_extensions, read_flows, write_flow
from onika.files.line import split
from onika.files.text_reading import TextReading
from onika.model.application import AppFlow, Branch, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax
from onika.words.reason import Reason

SYNTAX = Syntax(tuple(IconType(name, 0, 0) for name in ("Complete job", "Joint job", "Joint object")), ())
OPEN = Icon(Onikon("open", "Complete job", "", (), blank()))
CHOICE = Branch((AppFlow((OPEN,)), AppFlow(()), AppFlow((Hole(),))), ("LAMP == 1", "flow0/Q[1] > 2"))
DEEP = AppFlow((OPEN, Branch((AppFlow((CHOICE, OPEN)), AppFlow(())))))


def read(text: str, version: str = "2.0") -> tuple[tuple[AppFlow, ...], list[str]]:
    reading = TextReading("f", Reason.plain("it is left out"))
    reading.open_versioned(f"VERSION {version}\n{text}EOF\n", extended=True)
    flows = read_flows(split(reading.lines, HEADS)[1:], SYNTAX, reading)
    return flows, [f"{fault.place.line}: {fault.reason}" for fault in reading.faults]


def words(*lines: str) -> str:
    """A text in which `x` is a hole."""
    return "".join(("ICONHOLE" if line == "x" else line) + "\n" for line in lines)


def test_branches_are_read_as_they_were_written_to_any_depth() -> None:
    assert read(write_flow(DEEP)) == ((DEEP,), [])  # R-D13
    assert has_extensions(DEEP)
    assert not has_extensions(AppFlow((OPEN, Hole())))


def test_a_branch_looks_like_this() -> None:
    text = write_flow(AppFlow((CHOICE,))).replace(write_flow(AppFlow((OPEN,))), "")
    shown = [line for line in text.splitlines() if line and not line.startswith(("PICT", "UI", "DESC"))]
    assert shown == [
        "FLOW",
        "BRANCH",
        "FLOW        LAMP == 1",
        "ROUTINE     open",
        "MARKER      no",
        "ONIKON      Complete job",
        "ENDFLOW",
        "FLOW        flow0/Q[1] > 2",
        "ENDFLOW",
        "FLOW",
        "ICONHOLE",
        "ENDFLOW",
        "ENDBRANCH",
        "ENDFLOW",
    ]


def test_a_step_knows_its_line() -> None:
    (flow,), _ = read(words("FLOW", "BRANCH", "FLOW", "x", "ENDFLOW", "ENDBRANCH", "ENDFLOW"))
    (step,) = flow.steps
    assert isinstance(step, Branch)
    assert (step.line, step.flows[0].steps[0].line) == (3, 5)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (("FLOW", "BRANCH", "ENDBRANCH", "ENDFLOW"), ["4: expected at least one FLOW before ENDBRANCH, found none"]),
        (("FLOW", "BRANCH", "FLOW", "ENDFLOW", "ENDFLOW"), ["6: expected FLOW or ENDBRANCH, found 'ENDFLOW'"]),
        (("FLOW", "BRANCH", "FLOW", "ENDBRANCH", "ENDFLOW"),
         ["5: expected ENDFLOW before ENDBRANCH, found 'ENDBRANCH'"]),
        (("FLOW", "ENDBRANCH", "ENDFLOW"), ["3: expected BRANCH before ENDBRANCH, found 'ENDBRANCH'"]),
        (("FLOW", "BRANCH", "x", "ENDFLOW", "ENDBRANCH", "ENDFLOW"), ["4: expected FLOW, found 'ICONHOLE'"]),
        (("BRANCH", "FLOW", "ENDFLOW", "ENDBRANCH", "ENDFLOW"), ["2: expected FLOW, found 'BRANCH'"]),
        (("FLOW", "BRANCH", "FLOW", "ENDFLOW", "ENDBRANCH"),
         ["6: expected ENDFLOW, found the end of the application"]),
        (("FLOW", "BRANCH", "FLOW", "ENDFLOW"), ["5: expected ENDBRANCH, found the end of the application"]),
        (("FLOW", "BRANCH", "FLOW", "FLOW", "ENDFLOW", "ENDBRANCH", "ENDFLOW"),
         ["5: expected ENDFLOW before the next FLOW, found 'FLOW'"]),
        (("FLOW", "BRANCH x", "FLOW", "ENDFLOW", "ENDBRANCH", "ENDFLOW"),
         ["3: expected BRANCH alone on its line, found 'BRANCH x'"]),
        (("FLOW A == 1", "ENDFLOW"), ["2: expected FLOW alone on its line, found 'FLOW A == 1'"]),
    ],
)  # fmt: skip
def test_what_does_not_close_is_named_with_its_line(lines: tuple[str, ...], expected: list[str]) -> None:
    assert read(words(*lines))[1] == expected  # R-B07


@pytest.mark.parametrize(
    ("heads", "line"), [(("A == 1", "A == 2"), 6), (("", "A == 1"), 4), (("A == 1", "", ""), 6), (("A == 1",), 4)]
)
def test_each_flow_of_a_branch_but_the_last_has_a_condition_or_none_has(heads: tuple[str, ...], line: int) -> None:
    inner = [text for head in heads for text in (f"FLOW {head}".strip(), "ENDFLOW")]
    _, result = read(words("FLOW", "BRANCH", *inner, "ENDBRANCH", "ENDFLOW"))
    expected = "expected a condition after each FLOW of a branch but the last, or after none"
    assert result[0].startswith(f"{line}: {expected}, found ")


def test_a_wrong_condition_is_named() -> None:
    _, result = read(words("FLOW", "BRANCH", "FLOW lamp", "ENDFLOW", "FLOW", "ENDFLOW", "ENDBRANCH", "ENDFLOW"))
    assert result == ["4: expected a condition such as LAMP == 1 after FLOW, found 'FLOW lamp'"]


def test_an_older_file_has_no_branches() -> None:
    lines = words("FLOW", "BRANCH", "FLOW", "ENDFLOW", "ENDBRANCH", "ENDFLOW")  # R-B06
    assert read(lines, "1.3")[1] == [
        "3: expected VERSION 2.0 for a line BRANCH, found 'BRANCH'",
        "6: expected VERSION 2.0 for a line ENDBRANCH, found 'ENDBRANCH'",
    ]


def nested(depth: int) -> str:
    return words("FLOW", *("BRANCH", "FLOW") * depth, *("ENDFLOW", "ENDBRANCH") * depth, "ENDFLOW")


def test_branches_stand_within_each_other_a_hundred_times_at_most() -> None:
    (flow,), result = read(nested(DEEPEST))
    assert result == []
    assert read(write_flow(flow)) == ((flow,), [])
    assert read(nested(DEEPEST + 5000))[1] == [
        f"{2 * DEEPEST + 3}: expected at most 100 branches within each other, found one more"
    ]


def test_marks_of_targets_in_branches_go_to_their_jobs() -> None:
    move, home = (
        Icon(Onikon(name, kind, "", (), blank())) for name, kind in (("m", "Joint job"), ("h", "Joint object"))
    )
    text = write_flow(AppFlow((Branch((AppFlow((move, home)),)),)))
    at = text.rindex("MARKER      no")
    (flow,), result = read(text[:at] + "MARKER yes" + text[at + 14 :])
    assert result == []  # reading 24
    (step,) = flow.steps
    assert isinstance(step, Branch)
    assert [isinstance(step, Icon) and step.marker for step in step.flows[0].steps] == [True, False]


def test_the_depth_of_flows_is_that_of_their_branches() -> None:
    inner = AppFlow((Branch((AppFlow(()),)),))
    assert depth([AppFlow(())]) == 0
    assert depth([AppFlow(()), AppFlow((Branch((inner, AppFlow(()))),))]) == 2
    assert depth([]) == 0
