from dataclasses import replace

from tests.files.models import TYPES

from onika.files.al.writer import write
from onika.model.application import AppFlow, Application, Branch, Hole, Icon, Step
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import DataItem, IconType, Syntax
from onika.words.value import ValueType

GRIP = Onikon("opengrip", "Complete job", "open the hand", (), blank())
GO = Onikon("go", "Joint job", "", (), blank())
TIMED = Onikon("timed", "Joint job", "", (), blank(), ("Any object",))
NOOP = Onikon("noop", "Complete NOP", "", (), blank())
HOME = Onikon("home", "Joint object", "up, {out}", ((1.0, -2.5), ('x "y"',)), blank())
KNOWN = {item.name: item for item in (GRIP, GO, TIMED, NOOP, HOME)}


def lines(*steps: Step, is_parallel: bool = False) -> list[str]:
    """The lines of a flow within BEGIN and END."""
    application = Application("work", is_parallel, (AppFlow(steps),))
    return write(application, TYPES, KNOWN.get).splitlines()[2:-1]


def test_actions_stand_with_their_targets_and_new_icons_with_what_they_are() -> None:
    assert lines(Icon(GRIP), Icon(GO), Icon(HOME), Icon(GRIP), Icon(NOOP)) == [
        "  OPEN HAND opengrip  { open the hand }",
        '  DRIVE go TO home (1.0 -2.5; who="x \\"y\\"")  { up, {out) }',
        "  OPEN HAND opengrip",
        "  NOP noop",
    ]  # R-D14


def test_marks_stand_before_and_behind_their_action() -> None:
    marked = Icon(NOOP, marker=True, synch_tag="meet", marker_if="LAMP == 1")
    assert lines(marked, Icon(NOOP, marker=True), Icon(NOOP, marker_if="Q > 1")) == [
        "  SYNCH meet",
        "  NOP noop",
        "  BREAK IF LAMP == 1",
        "  NOP noop",
        "  BREAK",
        "  NOP noop",
        "  BREAK OFF IF Q > 1",
    ]


def test_well_formed_loops_are_blocks_and_others_are_tags() -> None:
    anchor, test = Icon(NOOP, while_tag="a"), Icon(NOOP, while_tag="a", while_test=True, while_if="L == 1")
    assert lines(anchor, test) == ["  REPEAT a", "    NOP noop", "    NOP noop", "  UNTIL NOT L == 1"]
    assert lines(test, anchor) == ["  WHILE a", "    NOP noop", "  DO IF L == 1", "    NOP noop", "  END WHILE"]
    plain = Icon(NOOP, while_tag="a", while_test=True)
    assert lines(anchor, plain)[-1] == "  UNTIL DONE"
    assert lines(plain, anchor)[2] == "  DO"
    assert lines(test) == ["  TAG a TEST IF L == 1", "  NOP noop"]
    assert lines(anchor)[0] == "  TAG a"


def test_branches_are_if_or_case() -> None:
    item, none = AppFlow((Icon(NOOP),)), AppFlow(())
    assert lines(Branch((item, item, none), ("L == 1", "L == 2"))) == [
        "  IF L == 1 THEN",
        "    NOP noop",
        "  ELSEIF L == 2 THEN",
        "    NOP noop",
        "  END IF",
    ]
    assert lines(Branch((none, item), ("L == 1",)))[1] == "  ELSE"
    assert lines(Branch((item, none))) == [
        "  CASE OF",
        "    BEGIN { flow 0 }",
        "      NOP noop",
        "    END",
        "    BEGIN { flow 1 }",
        "    END",
        "  END CASE",
    ]


def test_holes_and_stray_targets_stand_where_they_are() -> None:
    assert lines(Hole(), Icon(HOME), Icon(TIMED), Hole(), Icon(GO), Hole(kept="ROUTINE x\n"))[:4] == [
        "  HOLE",
        '  TO home (1.0 -2.5; who="x \\"y\\"")  { up, {out) }',
        "  DRIVE timed TO HOLE",
        "  DRIVE go TO HOLE #1",
    ]


def test_several_flows_stand_in_blocks() -> None:
    flows = (AppFlow(()), AppFlow((Icon(NOOP),)))
    for is_parallel, head, end in ((True, "COBEGIN", "COEND"), (False, "CASE OF", "END CASE")):
        text = write(Application("work", is_parallel, flows), TYPES, KNOWN.get)
        assert text == (
            f"{{ work }}\n{head}\n  BEGIN {{ flow 0 }}\n  END\n  BEGIN {{ flow 1 }}\n    NOP noop\n  END\n{end}\n"
        )


def test_long_values_are_broken_within_their_parentheses() -> None:
    many = Onikon("many", "Any object", "", tuple((float(at), 1e-300) for at in range(30)), blank())
    syntax = Syntax((IconType("Any object", 1, 0, (DataItem("all", ValueType.DOUBLE, 60),)),), ())
    target = replace(many, values=(sum(many.values, ()),))
    text = write(Application("work", False, (AppFlow((Icon(target),)),)), syntax, {"many": target}.get)
    result = text.splitlines()[2:-1]
    assert max(map(len, result)) <= 120
    assert len(result) > 2
    assert all(line.startswith("      ") for line in result[1:])


def test_without_a_dictionary_all_icons_are_defined() -> None:
    text = write(Application("work", False, (AppFlow((Icon(GO), Icon(HOME))),)), TYPES)
    assert [line for line in text.splitlines() if line.startswith(("ICON", "ONIKON", "WHERE", "END"))] == [
        "END",
        "WHERE",
        "ICON        go",
        "ONIKON      Joint job",
        "ICON        home",
        "ONIKON      Joint object",
        "END WHERE",
    ]
