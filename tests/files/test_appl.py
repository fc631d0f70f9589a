from dataclasses import replace

import pytest

from onika.files.appl import read, salvage, write
from onika.model.application import AppFlow, Application, Branch, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import DataItem, IconType, Syntax
from onika.words.value import ValueType

SYNTAX = Syntax(
    (
        IconType("Application start", 0, 0),
        IconType("Application end", 0, 0),
        IconType("Complete job", 0, 0),
        IconType("Joint job", 0, 1),
        IconType("Joint object", 1, 0, (DataItem("endpoint", ValueType.DOUBLE, 1),)),
    ),
    (),
)


def onikon(name: str, kind: str) -> Onikon:
    return Onikon(name, kind, "", ((1.0,),) if kind.endswith("object") else (), blank())


GRIP = Icon(onikon("grip", "Complete job"))
MOVE = Icon(onikon("move", "Joint job"), marker=True, synch_tag="meet", while_tag="again", while_test=True)
HOME = Icon(onikon("home", "Joint object"))
APPLICATION = Application("work", True, (AppFlow((GRIP, MOVE, HOME)), AppFlow((MOVE, Hole(), GRIP))))
TEXT = write(APPLICATION)


def flows(text: str) -> list[str]:
    """Every flow as the names of its icons, a hole as `_`."""
    application, faults = read(text, "work", "f", SYNTAX)
    assert application, faults
    return [
        " ".join(step.onikon.name if isinstance(step, Icon) else "_" for step in f.steps) for f in application.flows
    ]


def result(text: str) -> list[str]:
    _, faults = read(text, "work", "work.appl", SYNTAX)
    return [f"{fault.place.line}: {fault.reason}" for fault in faults]


def icon(name: str, kind: str, marks: str = "") -> str:
    text = write(Application("a", False, (AppFlow((Icon(onikon(name, kind)),)),)))
    block = text[text.index("ROUTINE") : text.index("ENDFLOW")]
    return block.replace("ONIKON", marks + "ONIKON", 1)


def application(*parts: str) -> str:
    return "VERSION 1.3\nAPPLTYPE conditional\nFLOW\n" + "\n".join(parts) + "\nENDFLOW\nEOF\n"


def test_an_application_is_read_and_written() -> None:
    assert read(TEXT, "work", "work.appl", SYNTAX) == (APPLICATION, ())  # R-B04
    assert TEXT.startswith(
        "VERSION     1.3\n\nAPPLTYPE    parallel\n\nFLOW\n\nROUTINE     grip\nMARKER      no\nONIKON"
    )
    marks = "MARKER      yes\nSYNCHTAG    meet\nWHILETAG    again\nWHILETEST   yes\nONIKON      Joint job\n"
    assert marks in TEXT


def test_comments_of_the_former_text_are_kept() -> None:
    former = TEXT.replace("ROUTINE     move", "# go\nROUTINE     move", 1)
    shorter = Application("work", True, APPLICATION.flows[:1])
    assert "# go\nROUTINE     move" in write(shorter, former)
    assert read(write(shorter, former), "work", "f", SYNTAX) == (shorter, ())


def test_start_and_end_icons_are_accepted_and_left_out() -> None:
    text = application(icon("s", "Application start"), icon("grip", "Complete job"), icon("e", "Application end"))
    assert flows(text) == ["grip"]  # reading 46
    assert result(text) == []


def test_adjacent_holes_are_one() -> None:
    assert flows(application("ICONHOLE", "ICONHOLE", icon("grip", "Complete job"), "ICONHOLE")) == ["_ grip _"]


def test_an_unknown_target_leaves_a_hole_and_an_unknown_job_stays() -> None:
    parts = (icon("move", "Joint job"), icon("push", "Force object"), icon("press", "Force job"))
    text = application(*parts).replace("UI          1.0", "UI 1.0")  # R-D16
    assert flows(text) == ["move _ press"]
    _, (first, second) = read(text, "work", "f", SYNTAX)
    assert str(first.instead) == "the icon is left out"
    assert str(second.instead) == "it acts as Complete job, its data is asked for while it runs"


def test_a_target_of_unknown_type_is_written_again_as_it_was() -> None:
    push, hit = (icon(name, "Force object", "SYNCHTAG x\n").replace("UI          1.0", "UI a  b") for name in "ph")
    first, _ = read(application(icon("move", "Joint job"), push, hit, "ICONHOLE", "ICONHOLE"), "w", "f", SYNTAX)
    assert first  # R-D16, R-B07
    text = write(first)
    assert text.count("ICONHOLE") == 1
    assert text.count("Force object") == 2
    assert "SYNCHTAG    x\n" in text
    again, _ = read(text, "w", "f", SYNTAX)
    assert again == first
    assert write(again) == text


def test_the_marks_of_a_target_belong_to_its_job() -> None:
    home = icon("home", "Joint object", "SYNCHTAG meet\nWHILETAG again\nWHILETEST yes\n").replace(
        "MARKER      no", "MARKER yes"
    )
    read_, faults = read(application(icon("move", "Joint job"), home), "work", "f", SYNTAX)  # reading 24
    assert faults == ()
    assert read_
    assert read_.flows == (AppFlow((MOVE, HOME)),)


def test_two_tags_on_one_action_are_a_fault() -> None:
    parts = [icon("move", "Joint job", "SYNCHTAG a\n"), icon("home", "Joint object", "SYNCHTAG b\n")]
    assert [fault.split(": ", 1)[1] for fault in result(application(*parts))] == [
        "expected one synch tag for a job and its target, found a and b"
    ]


def test_an_older_file_may_lack_type_and_markers() -> None:
    text = TEXT.replace("VERSION     1.3\n", "").replace("APPLTYPE    parallel\n", "").replace("MARKER      no\n", "")
    assert flows(text) == ["grip move home", "move _ grip"]  # R-B06


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("parallel", "sideways", "3: expected parallel or conditional after APPLTYPE, found 'APPLTYPE sideways'"),
        ("FLOW\n", "\n", "7: expected FLOW, found 'ROUTINE grip'"),
        ("ENDFLOW\n", "\n", "126: expected ENDFLOW before the next FLOW, found 'FLOW'"),
        ("FLOW\n", "FLOW x\n", "5: expected FLOW alone on its line, found 'FLOW x'"),
        ("MARKER      no", "MARKER maybe", "8: expected yes or no after MARKER, found 'MARKER maybe'"),
        ("ROUTINE     grip", "ROUTINE a b", "7: expected the name of an icon after ROUTINE, found 'ROUTINE a b'"),
        ("WHILETEST   yes\n", "", "48: expected WHILETEST after WHILETAG, found none"),
        ("WHILETAG    again\n", "", "48: expected WHILETAG before WHILETEST, found none"),
        (
            "MARKER      no\n",
            "SYNCHTAG x\nMARKER no\n",
            "9: expected MARKER before SYNCHTAG, found 'MARKER no' after it",
        ),
    ],
)
def test_what_is_wrong_is_named_with_its_line(old: str, new: str, expected: str) -> None:
    text = TEXT.replace(old, new, 1)  # R-B07
    assert expected in result(text)
    assert read(text, "work", "f", SYNTAX)[0] is None


def test_an_application_without_flows_is_a_fault() -> None:
    assert result("VERSION 1.3\nAPPLTYPE parallel\nEOF") == ["3: expected at least one FLOW, found none"]


def test_the_last_flow_must_end() -> None:
    assert (
        "expected ENDFLOW, found the end of the application"
        in result(application("ICONHOLE").replace("ENDFLOW\n", ""))[0]
    )


def test_a_file_is_of_version_2_0_only_where_1_3_has_no_words_for_it() -> None:
    assert TEXT.startswith("VERSION     1.3\n")  # R-B06, R-D13
    branch = Branch((AppFlow((GRIP,)), AppFlow(())), ("LAMP == 1",))
    whole = Application("work", True, (AppFlow((GRIP, branch)), AppFlow((MOVE, HOME))))
    text = write(whole)
    assert text.startswith("VERSION     2.0\n\nAPPLTYPE    parallel\n\nFLOW\n")
    assert read(text, "work", "f", SYNTAX) == (whole, ())
    conditional = replace(MOVE, marker_if="LAMP == 1")
    assert write(Application("work", True, (AppFlow((conditional, HOME)),))).startswith("VERSION     2.0")
    plain = read(TEXT.replace("1.3", "2.0", 1), "work", "f", SYNTAX)
    assert plain == (APPLICATION, ())
    assert write(APPLICATION) == TEXT


def test_comments_in_branches_are_kept() -> None:
    branch = Branch((AppFlow((GRIP,)), AppFlow((HOME,))))  # R-B01
    text = write(Application("work", False, (AppFlow((branch,)),)))
    former = text.replace("BRANCH", "# choose\nBRANCH", 1).replace("ENDBRANCH", "# chosen\nENDBRANCH", 1)
    changed = Application("work", False, (AppFlow((GRIP, branch)),))
    kept = write(changed, former)
    assert kept.index("# choose") < kept.index("\nBRANCH") < kept.index("# chosen") < kept.index("\nENDBRANCH")
    assert read(kept, "work", "f", SYNTAX) == (changed, ())


def salvaged(text: str) -> list[str]:
    application, _ = salvage(text, "work", "f", SYNTAX)
    assert application is not None
    return [
        " ".join(step.onikon.name if isinstance(step, Icon) else "_" for step in f.steps) for f in application.flows
    ]


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("EOF", "", ["grip move home", "move _ grip"]),
        ("parallel", "perhaps", ["grip move home", "move _ grip"]),
        ("ROUTINE     grip", "ROUTINE     no name", ["_ move home", "move _ grip"]),
        ("UI          1.0", "UI          one", ["grip move _", "move _ grip"]),
        ("PICT        8", "PICT        x", ["grip move home", "move _ grip"]),
        ("MARKER      no", "MARKER      so", ["grip move home", "move _ grip"]),
        ("ENDFLOW", "", ["grip move home", "move _ grip"]),
    ],
)
def test_what_can_be_read_of_a_broken_text_is(old: str, new: str, expected: list[str]) -> None:  # issue: bad input
    broken = TEXT.replace(old, new, 1)
    application, faults = read(broken, "work", "f", SYNTAX)
    assert application is None
    assert salvaged(broken) == expected
    assert salvage(broken, "work", "f", SYNTAX)[1] == faults


def test_what_could_not_be_read_as_an_icon_is_written_again() -> None:
    broken = TEXT.replace("UI          1.0", "UI          one", 1)
    application, _ = salvage(broken, "work", "f", SYNTAX)
    assert application is not None
    assert write(application, broken) == broken


def test_a_sound_text_is_the_same_either_way() -> None:
    assert salvage(TEXT, "work", "f", SYNTAX) == read(TEXT, "work", "f", SYNTAX)


@pytest.mark.parametrize("text", ["", "VERSION 9.9\nFLOW\nENDFLOW\nEOF\n", "VERSION 1.3\nEOF\n"])
def test_where_nothing_can_be_read_there_is_nothing(text: str) -> None:
    application, faults = salvage(text, "work", "f", SYNTAX)
    assert application is None
    assert faults


@pytest.mark.parametrize(("branches", "is_there"), [(100, True), (101, False), (3000, False)])
def test_branches_too_deep_for_anybody_are_not_opened(branches: int, is_there: bool) -> None:
    deep = "VERSION 2.0\nFLOW\n" + "BRANCH\nFLOW\n" * branches + "ENDFLOW\nENDBRANCH\n" * branches + "ENDFLOW\nEOF\n"
    assert (salvage(deep, "work", "f", SYNTAX)[0] is not None) == is_there


def test_two_targets_of_unknown_type_beside_each_other_are_both_kept() -> None:  # R-D16
    strange = icon("odd", "Complete job").replace("Complete job", "Odd object")
    text = application(icon("grip", "Complete job"), strange, strange)
    result, _ = read(text, "work", "f", SYNTAX)
    assert result is not None
    assert write(result).count("Odd object") == 2


def test_the_version_says_what_kept_lines_need() -> None:  # R-B09
    strange = icon("odd", "Complete job", "").replace("Complete job", "Odd object")
    text = application(icon("grip", "Complete job"), strange.replace("ONIKON", "MARKERIF LAMP == 1\nONIKON"))
    result, faults = read(text.replace("VERSION 1.3", "VERSION 2.0"), "work", "f", SYNTAX)
    assert result is not None, faults
    assert write(result).startswith("VERSION     2.0")


def test_the_larger_picture_of_a_kept_target_needs_version_2_0_too() -> None:  # R-B09
    strange = icon("odd", "Complete job").replace("Complete job", "Odd object")
    larger = strange.partition("PICT")[0] + "".join(f"PICT {row}\n" for row in blank(64).rows)
    for kept, version in ((strange, "1.3"), (larger, "2.0")):
        result, faults = read(application(kept).replace("VERSION 1.3", f"VERSION {version}"), "work", "f", SYNTAX)
        assert result is not None, faults
        assert write(result).startswith(f"VERSION     {version}")
    assert read(application(larger), "work", "f", SYNTAX)[0] is None
