from onika.files.al.block import Block, LoopMark, marked
from onika.files.al.logical_line import sentences
from onika.files.text_reading import TextReading
from onika.model.application import AppFlow, Branch, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.words.reason import NOTHING

(SENTENCE,), _ = sentences("\nIF LAMP == 1 THEN", TextReading("f", NOTHING))
ICON = Icon(Onikon("x", "Complete job", "", (), blank()))


def marks(icon: object) -> tuple[object, ...]:
    assert isinstance(icon, Icon)
    return icon.marker, icon.marker_if, icon.synch_tag, icon.while_tag, icon.while_test, icon.while_if


def test_an_action_bears_what_waited_for_it() -> None:
    block = Block("BEGIN", SENTENCE)  # R-D06
    block.synch = (SENTENCE, "meet")
    block.loop_mark = LoopMark(SENTENCE, "again", True, "LAMP == 1")
    block.add([ICON, Hole()])
    block.add([ICON])
    block.rest("Q > 1", is_off=False)
    first, hole, second = block.flow().steps
    assert marks(first) == (False, "", "meet", "again", True, "LAMP == 1")
    assert hole == Hole()
    assert marks(second) == (True, "Q > 1", None, None, False, "")
    assert not block.takes_break


def test_a_breakpoint_that_is_off_keeps_its_condition() -> None:
    block = Block("BEGIN", SENTENCE)
    block.add([ICON])
    block.rest("Q > 1", is_off=True)
    assert marks(block.flow().steps[0])[:2] == (False, "Q > 1")


def test_nothing_stands_for_a_statement_that_is_wrong() -> None:
    block = Block("BEGIN", SENTENCE)
    block.lose()
    assert block.takes_break
    block.rest("", is_off=False)
    assert not marked(block.items, 0, "again", is_test=True)
    assert block.flow() == AppFlow(())


def test_holes_side_by_side_are_one() -> None:
    block = Block("BEGIN", SENTENCE)
    for steps in ([Hole()], [Hole()], [Hole(kept="ROUTINE x\n")], [ICON]):
        block.add(steps)
    assert block.flow() == AppFlow((Hole(), Hole(kept="ROUTINE x\n"), ICON))  # reading 33


def test_a_branch_has_the_parts_that_were_read() -> None:
    block = Block("IF", SENTENCE, conditions=["LAMP == 1"])
    block.add([ICON])
    block.end_part()
    block.end_part()
    assert block.branch() == Branch((AppFlow((ICON,)), AppFlow(())), ("LAMP == 1",))
    assert block.branch().line == 2


def test_only_an_action_without_a_tag_bears_that_of_a_loop() -> None:
    tagged = Icon(ICON.onikon, while_tag="a")
    assert str(marked([], 0, "b", is_test=False)) == "nothing"
    assert str(marked([[Hole()]], 0, "b", is_test=False)) == "a hole"
    assert str(marked([[Branch(())]], 0, "b", is_test=False)) == "a branch"
    assert str(marked([[tagged]], 0, "b", is_test=False)) == "`x`, which bears the tag a"
    items = [[ICON], [ICON]]
    assert not marked(items, -1, "b", is_test=True, condition="Q > 1")
    assert [marks(item[0])[3:] for item in items] == [(None, False, ""), ("b", True, "Q > 1")]
