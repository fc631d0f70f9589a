"""One rule for all formats of Appendix A: what is written is read again, and damage is reported (R-B07, R-B08)."""

import string
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from onika.files import appl, buttons, conf, onk, picture, preferences, rmod, syntax
from onika.files.rmod import RmodText
from onika.model.application import AppFlow, Application, Hole, Icon
from onika.model.button import Button
from onika.model.configuration import Configuration, Locus, Placed
from onika.model.onikon import Onikon
from onika.model.picture import SIZE, framed
from onika.model.preferences import STATUS_COLUMNS, Preferences, Spot, Window
from onika.model.syntax import SPECIAL_TYPES, DataItem, Edge, IconType, Syntax
from onika.model.task import LocalLine, Task, TaskType
from onika.store.site import open_site, shipped, shipped_directories
from onika.words.fault import Fault
from onika.words.value import ValueType

TYPES = Syntax(
    types=(
        IconType("Application start", 0, 0),
        IconType("Application end", 0, 0),
        IconType("Complete job", 0, 0),
        IconType("Complete application", 0, 0),
        IconType("Complete NOP", 0, 0),
        IconType("Joint job", 0, 1),
        IconType("Joint application", 0, 1),
        IconType("Joint object", 1, 0, (DataItem("endpoint", ValueType.DOUBLE, 2), DataItem("who", ValueType.LINE, 1))),
        IconType("Any object", 1, 0, tuple(DataItem(kind.value, kind, 2) for kind in ValueType)),
    ),
    edges=(Edge(0, (1, 2, 3), ((-5, 5), (5, 5))), Edge(1, (255, 0, 0), ())),
)

# -- models

svar_names = st.from_regex(r"[A-Z][A-Z0-9_^]{0,5}", fullmatch=True).filter(lambda name: name != "NONE")
names = st.from_regex(r"[A-Za-z][A-Za-z0-9_.-]{0,8}", fullmatch=True)
prose = st.text(string.ascii_letters + '#=" éñ', max_size=20).map(lambda text: " ".join(text.split()))
some_prose = prose.filter(bool)
words = st.text(string.ascii_letters + string.digits + '#=".-+', min_size=1, max_size=8)
numbers = st.integers(-(10**6), 10**6)
counts = st.integers(0, 99)
sizes = st.integers(1, 9999)
rates = st.floats(1e-9, 1e9)
one_line_texts = st.text(st.characters(exclude_categories=("Cc", "Cs")), max_size=12)
pictures = st.lists(st.text("012345678", min_size=SIZE, max_size=SIZE), min_size=3, max_size=3).map(
    lambda rows: framed((rows * SIZE)[:SIZE])
)


@st.composite
def tasks(draw: st.DrawFn) -> Task:
    coded = draw(st.lists(svar_names, unique=True, max_size=6))
    svars = draw(st.permutations(coded)) if draw(st.booleans()) else [name + "_A" for name in coded]
    aliases = [pair for pair in zip(coded, svars, strict=True) if draw(st.booleans())]
    resolved = [dict(aliases).get(name, name) for name in coded]
    outputs = [name for name, svar in zip(coded, resolved, strict=True) if resolved.count(svar) == 1]
    lists = [tuple(draw(st.lists(st.sampled_from(of), unique=True))) if of else () for of in (coded, outputs) * 2]
    present = {name for names in lists for name in names}
    kind = draw(st.sampled_from(TaskType))
    return Task(
        name="t",
        module=draw(names),
        description=draw(prose),
        aliases=tuple(pair for pair in aliases if pair[0] in present),
        inconst=lists[0],
        outconst=lists[1],
        invar=lists[2],
        outvar=lists[3],
        type=kind,
        frequency=None if kind is TaskType.APERIODIC else draw(rates),
        gives_period=kind is not TaskType.APERIODIC and draw(st.booleans()),
        object_type=draw(st.none() | some_prose.map(lambda text: f"{text} job")),
        local=tuple(draw(st.lists(st.builds(LocalLine, _local_keys, st.lists(words, max_size=3).map(tuple))))),
    )


_local_keys = st.from_regex(r"[A-Za-z][A-Za-z0-9_^.-]{0,6}", fullmatch=True).filter(
    lambda key: key not in {slot.keyword for slot in rmod._SLOTS} | {"EOF"}
)

configurations = st.builds(
    Configuration,
    st.just("c"),
    st.lists(
        st.builds(Placed, names, numbers, numbers, st.booleans(), st.just(0.0) | rates, words),
        unique_by=lambda placed: placed.task,
        max_size=3,
    ).map(tuple),
    st.lists(
        st.builds(Locus, svar_names, numbers, numbers, counts, counts, counts, counts, counts, counts, st.booleans()),
        unique_by=lambda locus: locus.svar,
        max_size=3,
    ).map(tuple),
)


def element(kind: ValueType) -> st.SearchStrategy[Any]:
    if kind.is_text:
        return one_line_texts
    if kind is ValueType.CHAR:
        return st.characters(max_codepoint=255, exclude_categories=("Cc",))
    if kind.is_real:
        return st.floats(allow_nan=False, allow_infinity=False)
    low, high = map(int, kind.bounds)
    return st.integers(low, high)


def values(kind: IconType) -> st.SearchStrategy[Any]:
    return st.tuples(*(st.tuples(*(element(item.type),) * item.count) for item in kind.items))


def onikons_of(kind: IconType) -> st.SearchStrategy[Onikon]:
    return st.builds(Onikon, names, st.just(kind.name), prose, values(kind), pictures)


placeable = [kind for kind in TYPES.types if not (kind.is_start or kind.is_end)]
onikons = st.sampled_from(placeable).flatmap(onikons_of)


@st.composite
def icons(draw: st.DrawFn) -> Icon:
    tag = draw(st.none() | words)
    onikon = draw(onikons)
    if TYPES.find(onikon.type) in TYPES.types[-2:]:
        return Icon(onikon)  # marks live on the action (decision 24)
    return Icon(onikon, draw(st.booleans()), draw(st.none() | words), tag, tag is not None and draw(st.booleans()))


def _without_twin_holes(steps: list[Any]) -> AppFlow:
    kept = [step for at, step in enumerate(steps) if not (step == Hole() and at and steps[at - 1] == Hole())]
    return AppFlow(tuple(kept))


flows = st.lists(st.just(Hole()) | icons(), max_size=3).map(_without_twin_holes)
applications = st.builds(Application, st.just("a"), st.booleans(), st.lists(flows, min_size=1, max_size=2).map(tuple))

spots = st.builds(Spot, numbers, numbers)
windows = st.builds(Window, numbers, numbers, sizes, sizes)
columns = st.lists(st.sampled_from(STATUS_COLUMNS), unique=True).map(tuple)
all_preferences = st.builds(
    Preferences,
    *(sizes,) * 6,
    *(st.booleans(),) * 4,
    *(sizes,) * 2,
    st.booleans(),
    *(windows, windows, spots, spots, windows, windows, spots, spots),
    columns,
)
commands = st.text(string.ascii_letters + "#=\"' \t", min_size=1).map(lambda text: text.strip()).filter(bool)
all_buttons = st.lists(st.builds(Button, some_prose, commands, st.booleans()), max_size=3).map(tuple)


@st.composite
def syntaxes(draw: st.DrawFn) -> Syntax:
    numbers_ = draw(st.lists(st.integers(0, 20), unique=True, min_size=1, max_size=4))
    edge_numbers = st.sampled_from(numbers_)
    moves = st.lists(st.tuples(st.integers(-20, 20), st.integers(-20, 20)), max_size=3).map(tuple)
    colours = st.tuples(*(st.integers(0, 255),) * 3)
    items = st.lists(st.builds(DataItem, some_prose, st.sampled_from(ValueType), st.integers(1, 9)), max_size=3)
    types = [IconType(name, draw(edge_numbers), draw(edge_numbers)) for name in SPECIAL_TYPES]
    for at in range(draw(st.integers(0, 3))):
        word = draw(st.sampled_from(["job", "Application", "OBJECT", "thing"]))
        of = tuple(draw(items)) if word == "OBJECT" else ()
        types.append(IconType(f"x{at} {word}", draw(edge_numbers), draw(edge_numbers), of))
    return Syntax(tuple(types), tuple(Edge(number, draw(colours), draw(moves)) for number in numbers_))


# -- formats


@dataclass(frozen=True)
class Format:
    name: str
    ending: str
    models: st.SearchStrategy[Any]
    write: Callable[[Any], str]
    read: Callable[[str], tuple[Any, tuple[Fault, ...]]]


def _read_task(text: str) -> tuple[Any, tuple[Fault, ...]]:
    record, faults = rmod.read(text, "t", "f")
    return record and (record.task, record.task.gives_period), faults


FORMATS = [
    Format(
        "task",
        rmod.ENDING,
        tasks().map(lambda task: (task, task.gives_period)),
        lambda pair: rmod.write(RmodText(pair[0])),
        _read_task,
    ),
    Format("configuration", conf.ENDING, configurations, conf.write, lambda text: conf.read(text, "c", "f")),
    Format(
        "onikon",
        onk.ENDING,
        onikons.map(lambda onikon: Onikon("o", onikon.type, onikon.description, onikon.values, onikon.picture)),
        onk.write,
        lambda text: onk.read(text, "o", "f", TYPES),
    ),
    Format("application", appl.ENDING, applications, appl.write, lambda text: appl.read(text, "a", "f", TYPES)),
    Format("syntax", "OnikaUpperSetUp.dta", syntaxes(), syntax.write, lambda text: syntax.read(text, "s", "f")),
    Format("preferences", ".onika", all_preferences, preferences.write, lambda text: preferences.read(text, "p", "f")),
    Format("buttons", ".onika.buttons", all_buttons, buttons.write, lambda text: buttons.read(text, "b", "f")),
    Format("picture", "picture.dta", pictures, picture.write, lambda text: picture.read(text, "p", "f")),
]


JUNK = ["?? garbled ??", "xyz", "EOF x", "\x00", "FREQ", "8" * 31, "UI none none"]


def every_format(test: Callable[..., None]) -> Callable[..., None]:
    return pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)(test)


@every_format
@given(data=st.data())
@settings(max_examples=30, deadline=None)
def test_what_is_written_is_read_again_as_the_same_model_and_the_same_bytes(form: Format, data: st.DataObject) -> None:
    model = data.draw(form.models)  # R-B08
    text = form.write(model)
    read, faults = form.read(text)
    assert faults == ()
    assert read == model
    assert form.write(read) == text


@every_format
@given(data=st.data())
@settings(max_examples=15, deadline=None)
def test_a_file_cut_at_any_line_is_reported(form: Format, data: st.DataObject) -> None:
    lines = form.write(data.draw(form.models)).splitlines(keepends=True)  # R-B07
    for end in range(len(lines)):
        _, faults = form.read("".join(lines[:end]))
        assert faults, f"cut before line {end + 1}"


@every_format
@given(
    data=st.data(), junk=st.sampled_from(["?? garbled ??", "xyz", "EOF x", "\x00", "FREQ", "8" * 31, "UI none none"])
)
@settings(max_examples=30, deadline=None)
def test_a_line_replaced_by_junk_is_reported(form: Format, data: st.DataObject, junk: str) -> None:
    lines = form.write(data.draw(form.models)).splitlines()  # R-B07
    at = data.draw(st.sampled_from([at for at, line in enumerate(lines) if line]))
    meaning, _ = form.read("\n".join(lines) + "\n")
    lines[at] = junk
    read, faults = form.read("\n".join(lines) + "\n")
    free = form.name == "task" and "LOCAL" in [line.strip() for line in lines[:at]] and junk in ("xyz", "UI none none")
    assert faults or read == meaning or free


@every_format
@given(data=st.data())
@settings(max_examples=30, deadline=None)
def test_a_line_with_a_control_sign_is_reported(form: Format, data: st.DataObject) -> None:
    text = form.write(data.draw(form.models))
    at = data.draw(st.integers(0, len(text) - 1))
    sign = data.draw(st.sampled_from("\x00\x01\x1b\x7f\x85\r"))
    _, faults = form.read(text[:at] + sign + "x" + text[at:])
    line = text.count("\n", 0, at) + 1
    assert line in [fault.place.line for fault in faults]


@every_format
@given(data=st.data())
@settings(max_examples=15, deadline=None)
def test_two_lines_exchanged_are_reported_or_mean_the_same(form: Format, data: st.DataObject) -> None:
    lines = form.write(data.draw(form.models)).splitlines()  # decision 41
    solid = [at for at, line in enumerate(lines) if line]
    one, other = data.draw(st.sampled_from(solid)), data.draw(st.sampled_from(solid))
    is_order_free = lines[one].split()[0] == lines[other].split()[0] or form.name in ("picture", "task")
    meaning, _ = form.read("\n".join(lines) + "\n")
    lines[one], lines[other] = lines[other], lines[one]
    read, faults = form.read("\n".join(lines) + "\n")
    assert faults or read == meaning or is_order_free


@every_format
@given(text=st.text(max_size=200))
@settings(max_examples=30, deadline=None)
def test_no_text_at_all_raises_an_exception(form: Format, text: str) -> None:
    _, faults = form.read(text)
    meant = [line.strip() for line in text.splitlines() if line.strip() and not line.startswith("#")]
    is_empty = form.name in ("configuration", "preferences", "buttons") and meant == ["EOF"]  # and of an old version
    assert faults or is_empty
    assert all(str(fault) and fault.place.file == "f" for fault in faults)


@every_format
@given(data=st.data())
@settings(max_examples=30, deadline=None)
def test_lines_in_any_number_and_order_give_a_model_or_a_fault(form: Format, data: st.DataObject) -> None:
    lines = [line for line in form.write(data.draw(form.models)).splitlines() if line]  # R-B07
    soup = data.draw(st.lists(st.sampled_from([*lines, "EOF"]), max_size=12))
    for end in ("", "EOF\n"):
        model, faults = form.read("".join(line + "\n" for line in soup) + end)
        assert model is not None or faults


@every_format
@given(data=st.data())
@settings(max_examples=15, deadline=None)
def test_comments_and_blank_lines_mean_nothing(form: Format, data: st.DataObject) -> None:
    if form.name == "picture":
        return  # "nor are there any other lines in the files" (A.8)
    model = data.draw(form.models)
    lines = form.write(model).splitlines()
    for _ in range(3):
        lines.insert(data.draw(st.integers(0, len(lines))), data.draw(st.sampled_from(["", " \t", "# x", "\t# EOF"])))
    blank = data.draw(st.sampled_from(["\n", "\r\n", "\t\n"]))
    assert form.read(blank.join(lines)) == (model, ())


@every_format
@given(data=st.data())
@settings(max_examples=10, deadline=None)
def test_a_newer_version_is_refused_with_one_clear_fault(form: Format, data: st.DataObject) -> None:
    text = form.write(data.draw(form.models))  # R-B06
    if form.name in ("task", "picture"):
        return  # the two formats that have no VERSION
    assert text.startswith("VERSION")
    _, faults = form.read(text.replace("1.3\n", "2.0\nNEWWORD x\n", 1))
    assert [fault.expected for fault in faults] == ["a file of version 1.3 or older"]
    read, _ = form.read(text.replace("1.3\n", "1.2\n", 1))
    assert form.write(read) == text


@given(before=tasks(), after=tasks(), data=st.data())
@settings(max_examples=100, deadline=None)
def test_a_changed_task_keeps_the_comments_of_its_file(before: Task, after: Task, data: st.DataObject) -> None:
    lines = rmod.write(RmodText(before)).splitlines()  # R-B01
    for number in range(3):
        lines.insert(data.draw(st.integers(0, len(lines))), f"# comment {number}")
    text = "\n".join(lines) + "\n"
    record, _ = rmod.read(text, "t", "f")
    assert record and rmod.write(record) == text
    changed = rmod.write(record, after)
    again, faults = rmod.read(changed, "t", "f")
    assert faults == ()
    assert again and (again.task, again.task.gives_period) == (after, after.gives_period)
    assert sorted(line for line in changed.splitlines() if line.startswith("#")) == sorted(
        line for line in lines if line.startswith("#")
    )


# -- the files that ship


def shipped_files() -> list[Path]:
    folders = [base / folder for base in shipped_directories() for folder in ("module", "conf", "dict", "appl")]
    found = [path for folder in (*folders, shipped() / "prefs") for path in sorted(folder.glob("*"))]
    return [path for path in found if path.suffix in (".rmod", ".conf", ".onk", ".appl", ".dta")]


def reader(path: Path, types: Syntax) -> Callable[[str], tuple[Any, tuple[Fault, ...]]]:
    name = path.stem
    if path.name.endswith(syntax.NAME):
        return lambda text: syntax.read(text, name, path.name)
    return {
        ".rmod": lambda text: rmod.read(text, name, path.name),
        ".conf": lambda text: conf.read(text, name, path.name),
        ".onk": lambda text: onk.read(text, name, path.name, types),
        ".appl": lambda text: appl.read(text, name, path.name, types),
        ".dta": lambda text: picture.read(text, name, path.name),
    }[path.suffix]


def writer(path: Path) -> Callable[[Any], str]:
    if path.name.endswith(syntax.NAME):
        return syntax.write
    formats = {".rmod": rmod, ".conf": conf, ".onk": onk, ".appl": appl, ".dta": picture}
    return formats[path.suffix].write  # type: ignore[attr-defined]


def every_shipped_file() -> Iterator[tuple[Path, str, Callable[[str], tuple[Any, tuple[Fault, ...]]]]]:
    types, faults = open_site([], {}, None).syntax()
    assert types is not None and faults == ()
    for path in shipped_files():
        yield path, path.read_text("utf-8"), reader(path, types)


def test_every_shipped_file_is_without_fault_and_keeps_its_meaning() -> None:
    for path, text, read in every_shipped_file():  # R-B08
        record, faults = read(text)
        assert faults == (), path
        again, faults = read(writer(path)(record))
        assert faults == ()
        assert writer(path)(again) == writer(path)(record), path
        if path.suffix == ".rmod":
            assert writer(path)(record) == text
        else:
            assert again == record


def test_every_shipped_file_cut_or_garbled_at_a_line_is_reported_or_means_the_same() -> None:
    for path, text, read in every_shipped_file():  # R-B07
        lines = text.splitlines(keepends=True)
        record, _ = read(text)
        end = next((at for at, line in enumerate(lines) if line.strip() == "EOF"), len(lines) - 1)
        step = max(1, len(lines) // 40)  # a picture's rows are all alike
        for at in range(0, end + 1, step):
            assert read("".join(lines[:at]))[1], f"{path} cut before line {at + 1}"
            garbled, faults = read("".join([*lines[:at], "?? garbled ??\n", *lines[at + 1 :]]))
            is_comment = not lines[at].strip() or lines[at].lstrip().startswith("#")
            assert faults or (is_comment and garbled == record), f"{path}:{at + 1} garbled"
