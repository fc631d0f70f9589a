"""An application written as text is read back as the same one, whatever it is (R-D14)."""

from collections.abc import Callable

from hypothesis import given, settings, strategies as st
from tests.files.models import TYPES, applications, onikons

from kit.examples import examples
from onika.files import appl
from onika.files.al.reader import read
from onika.files.al.writer import write
from onika.model.application import AppFlow, Application, Hole, Icon, every_flow
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.words.reason import Reason

JUNK = ["END", "COEND", "BEGIN", "COBEGIN", "UNTIL", "ELSE", "DO", "HOLE", "TO", "NOP", "BREAK", "WHERE", "x"]
JUNK += ["}", "{", '"', "(", ")", ";", "=", "#1", "\x00"]
JUNK += ["END IF", "END WHILE", "END CASE", "CASE OF", "WHILE a", "REPEAT a", "IF A == 1 THEN", "TAG a TEST", "SYNCH a"]
KEPT = "ROUTINE     push\nMARKER      no\nONIKON      Force object\nDESC        {x}\nUI          a  b\n"


@st.composite
def tagged(draw: st.DrawFn) -> Application:
    """Few tags at many icons: loops within loops, crossing ones, lonely ends."""
    onikon = draw(onikons.filter(lambda item: not item.type.endswith("object")))
    made = [Icon(onikon, while_tag=tag, while_test=test) for tag in ("a", "END", "c") for test in (False, True)]
    steps = draw(st.lists(st.sampled_from([Icon(onikon), *made]), max_size=9))
    return Application("a", draw(st.booleans()), (AppFlow(tuple(steps)),))


@st.composite
def paired(draw: st.DrawFn) -> Application:
    """Actions with their targets, among few names, some with a hole or a target of unknown type in its place."""
    few = st.sampled_from(["home", "TO", "jmove", "opengrip"])
    result = draw(st.lists(onikons, min_size=1, max_size=6))
    steps: list[Icon | Hole] = [
        Icon(Onikon(draw(few), item.type, item.description, item.values, item.picture, item.more_targets))
        for item in result
    ]
    if draw(st.booleans()):
        picture = "".join(f"PICT        {row}\n" for row in blank().rows)
        steps.insert(draw(st.integers(0, len(steps))), Hole(kept=KEPT + picture))
    return Application("a", draw(st.booleans()), (AppFlow(tuple(steps)),))


def dictionary_of(application: Application, kept: Callable[[], bool]) -> Callable[[str], Onikon | None]:
    """A dictionary of some of its icons, of each name the last."""
    steps = [step for _, flow in every_flow(application) for step in flow.steps]
    return {step.onikon.name: step.onikon for step in steps if isinstance(step, Icon) and kept()}.get


def faults_of(text: str) -> list[str]:
    application, faults = read(text, "a", "a.al", TYPES)
    assert (application is None) == any(not fault.is_note for fault in faults)
    return [str(fault) for fault in faults]


@given(application=applications | tagged() | paired(), data=st.data())
@settings(max_examples=examples(150), deadline=None)
def test_any_application_is_read_back_as_the_same_and_its_file_has_the_same_bytes(
    application: Application, data: st.DataObject
) -> None:
    dictionary = dictionary_of(application, lambda: data.draw(st.booleans()))  # R-D14
    text = write(application, TYPES, dictionary)
    again, faults = read(text, "a", "a.al", TYPES, dictionary)
    assert [fault for fault in faults if not fault.is_note] == []
    assert again == application
    assert appl.write(again) == appl.write(application)
    assert write(again, TYPES, dictionary) == text


@given(application=applications | tagged())
@settings(max_examples=examples(30), deadline=None)
def test_a_whole_text_needs_no_dictionary_and_ignores_any(application: Application) -> None:
    def other(name: str) -> Onikon:
        return Onikon(name, "Complete job", "another", (), blank())

    again, _ = read(write(application, TYPES), "a", "a.al", TYPES, other)
    assert again == application


@given(application=applications)
@settings(max_examples=20, deadline=None)
def test_a_text_cut_at_any_line_is_reported(application: Application) -> None:
    lines = write(application, TYPES).splitlines(keepends=True)  # R-B07
    for end in range(len(lines)):
        if any(line.strip() and not line.startswith("{") for line in lines[end:]):
            complete = "".join(lines[:end]).rstrip().endswith(("END", "COEND", "END CASE"))
            assert faults_of("".join(lines[:end])) or (complete and "WHERE\n" not in lines[:end])


@given(application=applications, data=st.data())
@settings(max_examples=examples(60), deadline=None)
def test_a_garbled_text_gives_an_application_or_faults_with_lines(
    application: Application, data: st.DataObject
) -> None:
    lines = write(application, TYPES).splitlines()  # R-B07
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(lines) - 1))
        lines[at] = data.draw(st.sampled_from([*JUNK, *lines]))
    text = "\n".join(lines)
    _, faults = read(text, "a", "a.al", TYPES)
    assert all(fault.place.file == "a.al" and 0 <= fault.place.line <= len(lines) for fault in faults)
    faults_of(text)


@given(text=st.text(max_size=200) | st.lists(st.sampled_from([*JUNK, "a", "1", "\n"]), max_size=40).map(" ".join))
@settings(max_examples=examples(100), deadline=None)
def test_no_text_at_all_raises_an_exception(text: str) -> None:
    faults_of(text)


def test_comments_blank_lines_and_indents_mean_nothing() -> None:
    noop = Onikon("noop", "Complete NOP", "", (), blank())
    text = "\ufeff{ a\nb }\r\n\n BEGIN{x}\n\t NOP\tnoop { y }\r\nEND"
    assert read(text, "a", "f", TYPES, {"noop": noop}.get) == (Application("a", False, (AppFlow((Icon(noop),)),)), ())


def test_the_marks_of_a_target_are_those_of_its_job() -> None:
    job = Onikon("go", "Joint job", "", (), blank())
    target = Onikon("home", "Joint object", "", ((1.0, 2.0), ("x",)), blank())
    text = "BEGIN\nDRIVE go\nSYNCH meet\nTO home\nBREAK\nEND\n"  # reading 24
    read_, faults = read(text, "a", "f", TYPES, {"go": job, "home": target}.get)
    assert faults == ()
    assert read_
    assert read_.flows == (AppFlow((Icon(job, marker=True, synch_tag="meet"), Icon(target))),)


def test_marks_that_contradict_each_other_are_told() -> None:
    job = Onikon("go", "Joint job", "", (), blank())
    target = Onikon("home", "Joint object", "", ((1.0, 2.0), ("x",)), blank())
    text = "BEGIN\nSYNCH one\nDRIVE go\nSYNCH two\nTO home\nEND\n"
    result, (fault,) = read(text, "a", "f", TYPES, {"go": job, "home": target}.get)
    assert result is None
    meaning = Reason.of("files.synch_tag")
    assert fault.reason == Reason.of("files.icons_disagree", meaning=meaning, first="one", second="two")
