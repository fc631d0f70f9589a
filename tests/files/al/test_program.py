import pytest
from tests.files.models import TYPES

from onika.files.al.logical_line import sentences
from onika.files.al.program import TextProgram
from onika.files.al.where_section import WhereSection
from onika.files.text_reading import TextReading
from onika.model.application import AppFlow, Branch, Hole, Step
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.words.reason import Reason

KNOWN = {name: Onikon(name, "Complete job", "", (), blank()) for name in "abcdefg"}


def run(text: str) -> tuple[TextProgram, tuple[AppFlow, ...] | None, list[str]]:
    """A program after all its sentences, `/` standing for the end of a line; its flows and faults."""
    reading = TextReading("f", Reason.plain("nothing"))
    result, _ = sentences(text.replace(" / ", "\n"), reading)
    program = TextProgram(TYPES, WhereSection(KNOWN.get), reading)
    for item in result:
        program.take(item)
    flows = program.end()
    return program, flows, [f"{fault.place.line}: {fault.reason}" for fault in reading.faults]


def shown(step: Step) -> str:
    """A step in short: `a@meet` a synch tag, `a+t` an anchor, `a?t` a test, `a!` a breakpoint."""
    if isinstance(step, Hole):
        return "_"
    if isinstance(step, Branch):
        inner = [" ".join(map(shown, flow.steps)) for flow in step.flows]
        return f"[{' | '.join(inner)}{''.join(f' ; {condition}' for condition in step.conditions)}]"
    synch = f"@{step.synch_tag}" if step.synch_tag else ""
    loop = f"{'?' if step.while_test else '+'}{step.while_tag}" if step.while_tag else ""
    conditions = "".join(f"<{item}>" for item in (step.while_if, step.marker_if) if item)
    return step.onikon.name + synch + loop + "!" * step.marker + conditions


def flow(text: str) -> str:
    """The single flow of statements."""
    _, flows, faults = run(f"BEGIN / {text} / END")
    assert faults == []
    assert flows
    return " ".join(map(shown, flows[0].steps))


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("DO a / DO b", "a b"),
        ("SYNCH meet / DO a / BREAK / DO b / BREAK IF L == 1", "a@meet! b!<L == 1>"),
        ("DO a / BREAK OFF IF L == 1", "a<L == 1>"),
        ("REPEAT t / DO a / HOLE / DO b / UNTIL DONE", "a+t _ b?t"),
        ("REPEAT t / DO a / DO b / UNTIL NOT L == 1", "a+t b?t<L == 1>"),
        ("WHILE t / DO a / DO / DO b / DO c / END WHILE", "a?t b c+t"),
        ("WHILE t / DO a / BREAK / DO IF L == 1 / DO b / END WHILE / DO c", "a?t!<L == 1> b+t c"),
        ("REPEAT t / DO a / REPEAT u / DO b / DO c / UNTIL DONE / DO d / UNTIL DONE", "a+t b+u c?u d?t"),
        (
            "TAG t / DO a / TAG u / SYNCH m / DO b / TAG t TEST / DO c / TAG u TEST IF L == 1 / DO d",
            "a+t b@m+u c?t d?u<L == 1>",
        ),
        ("IF L == 1 THEN / DO a / END IF", "[a |  ; L == 1]"),
        ("IF L == 1 THEN / ELSEIF L == 2 THEN / DO b / ELSE / DO c / END IF", "[ | b | c ; L == 1 ; L == 2]"),
        ("DO a / CASE OF / BEGIN / DO b / END / BEGIN / END / END CASE / DO c", "a [b | ] c"),
        ("IF L == 1 THEN / CASE OF / BEGIN / HOLE / END / END CASE / ELSE / END IF", "[[_] |  ; L == 1]"),
    ],
)
def test_every_construct_is_its_steps(text: str, steps: str) -> None:
    assert flow(text) == steps  # R-D14, R-D13, R-E05


@pytest.mark.parametrize(
    ("text", "is_parallel", "count"),
    [
        ("BEGIN / END", False, 1),
        ("COBEGIN / BEGIN / END / COEND", True, 1),
        ("COBEGIN / BEGIN / END / BEGIN / DO a / END / COEND", True, 2),
        ("CASE OF / BEGIN / END / BEGIN / END / END CASE", False, 2),
    ],
)
def test_blocks_that_stand_outermost_are_the_flows(text: str, is_parallel: bool, count: int) -> None:
    program, flows, faults = run(text)
    assert faults == []
    assert flows
    assert (program.is_parallel, len(flows)) == (is_parallel, count)


@pytest.mark.parametrize(
    ("text", "complaints"),
    [
        ("", ["1: expected BEGIN, COBEGIN or CASE OF, found an empty text"]),
        ("DO a", ["1: expected BEGIN, COBEGIN or CASE OF, found 'DO a'"]),
        ("BEGIN", ["1: expected END for 'BEGIN' of line 1, found the end of the program"]),
        ("BEGIN / END / DO a / DO b", ["3: expected nothing behind the program but WHERE, found 'DO a'"]),
        ("COBEGIN / DO a / COEND", ["2: expected BEGIN, found 'DO a'"]),
        ("COBEGIN / COEND", ["2: expected BEGIN and END within COBEGIN, found none"]),
        ("BEGIN / BEGIN / END", ["2: expected BEGIN only at the begin or within COBEGIN or CASE OF, found 'BEGIN'"]),
        ("BEGIN / COBEGIN / END", ["2: expected COBEGIN only at the begin, found 'COBEGIN'"]),
        ("BEGIN / END IF / END", ["2: expected IF before END IF, found none open"]),
        ("BEGIN / IF L == 1 THEN / END", ["3: expected END IF for 'IF L == 1 THEN' of line 2, found 'END'"]),
        (
            "BEGIN / IF L THEN / END IF / END",
            ["2: expected an address, a comparison and a number, as in 'LAMP == 1', found 'L'"],
        ),
        ("BEGIN / IF L == 1 THEN / ELSE / ELSE / END IF / END", ["4: expected END IF, found 'ELSE'"]),
        ("BEGIN / SYNCH m / HOLE / END", ["2: expected an action on the next line, found none behind 'SYNCH m'"]),
        ("BEGIN / TAG t / END", ["2: expected an action on the next line, found none behind 'TAG t'"]),
        ("BEGIN / SYNCH m / SYNCH n / DO a / END", ["3: expected one SYNCH before an action, found 'SYNCH n'"]),
        ("BEGIN / TAG m / TAG n / DO a / END", ["3: expected one TAG before an action, found 'TAG n'"]),
        ("BEGIN / BREAK / END", ["2: expected an action before BREAK, found 'BREAK'"]),
        ("BEGIN / DO a / BREAK / BREAK / END", ["4: expected an action before BREAK, found 'BREAK'"]),
        ("BEGIN / DO a / BREAK OFF / END", ["3: expected IF and a condition behind BREAK OFF, found 'BREAK OFF'"]),
        (
            "BEGIN / REPEAT / DO a / DO b / UNTIL DONE / END",
            ["2: expected a tag of one word, found the end of the line"],
        ),
        (
            "BEGIN / REPEAT t / DO a / UNTIL DONE / END",
            ["2: expected two actions in the loop t, of which NOP may be one, found 1 statements"],
        ),
        (
            "BEGIN / REPEAT t / DO a / HOLE / UNTIL DONE / END",
            ["2: expected an action without a tag as the last in the loop t, found a hole"],
        ),
        (
            "BEGIN / REPEAT t / DO a / DO b / UNTIL / END",
            ["5: expected DONE or NOT and a condition behind UNTIL, found the end of the line"],
        ),
        ("BEGIN / WHILE t / DO a / END WHILE / END", ["4: expected DO before END WHILE, found 'END WHILE'"]),
        (
            "BEGIN / WHILE t / DO / DO a / END WHILE / END",
            ["2: expected one action between WHILE and DO of the loop t, found 0 statements"],
        ),
        (
            "BEGIN / WHILE t / DO a / DO / END WHILE / END",
            ["2: expected an action without a tag as the last behind the DO in the loop t, found nothing"],
        ),
        ("BEGIN / DO h / BREAK / END", ["2: expected an icon `h` in the dictionary or under WHERE, found none"]),
    ],
)
def test_each_wrong_sentence_is_told_once(text: str, complaints: list[str]) -> None:
    assert run(text)[2] == complaints  # R-B07


def test_an_unknown_word_is_told_with_the_known_ones() -> None:
    (complaint,) = run("BEGIN / go a / END")[2]
    assert complaint.startswith("2: expected a word of the language (DRIVE MOVE ")
    assert complaint.endswith(", found 'go a'")


def test_branches_nest_as_deep_as_a_file_may_have_them_and_no_deeper() -> None:
    def nested(depth: int) -> str:
        return " / ".join(["BEGIN", *["IF L == 1 THEN"] * depth, *["END IF"] * depth, "END"])

    assert run(nested(100))[2] == []
    assert run(nested(3000))[2] == ["102: expected at most 100 branches within each other, found one more"]
    loops = [f"REPEAT t{at} / DO a" for at in range(300)] + ["DO a / UNTIL DONE"] * 300
    assert run(" / ".join(["BEGIN", *loops, "END"]))[2] == []
