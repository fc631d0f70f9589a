from types import NoneType, UnionType
from typing import Any, Literal, get_args, get_origin, get_type_hints

import msgspec
import pytest

from onika.desk.environment.diary_entry import _EVENTS, DiaryEntry, entries
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.outcome import No
from onika.files.state.session_log import COLUMNS
from onika.wire import act
from onika.words.reason import Reason

NAMES = {"c1": "Untitled-1", "c2": "move"}
OF_THE_PAGE = {act.ListSets, act.LoadModule, act.Watch, act.Scene, act.Peek, act.Seats, act.FindWorlds, act.Company}
OF_THE_PAGE |= {
    act.Meshes,
    act.Recordings,
    act.Glance,
    act.Course,
    act.RecordedScene,
    act.SampleVariables,
    act.ForeseenInstant,
    act.LookAtBookings,
    act.LookAtNetwork,
    act.Push,
    act.SteerReplay,
}
"""What a page asks for by itself, as it shows something, or of a replay; of a pad that leads it notes who takes it."""
UNTOLD = {"token", "secret", "stamp", "user", "to"}
"""A secret, or who somebody is; and by which reading a text is judged, which stands in the record of its line."""
PLACES = {"doc", "step", "steps", "after", "test", "anchor"}
"""Told by the ids of the act's line, or the line itself."""


def columns(wish, value=None, no=None):
    return entries(wish, ActAnswer(value, no), NAMES)[0].columns(770909683.25)


def test_a_line_has_the_seven_columns_of_the_thesis():  # R-H01, §E.2
    line = columns(act.Place("c2", "pd", 3, 4))
    assert line == ("770909683.250", "insert_icon", "pd", "c2/pd", "move", "c2", "conf")
    assert len(COLUMNS) == 7


@pytest.mark.parametrize(
    ("wish", "value", "rest"),
    [
        (act.New(), "c1", "new_conf Untitled-1 c1 none 0 conf"),
        (act.Open("/lab/conf/move.conf"), "c2", "open_conf move c2 none 0 conf"),
        (act.Save("c2"), None, "save_conf move c2 none 0 conf"),
        (act.Save("c2", "other"), None, "save_conf other c2/other move c2 conf"),
        (act.Exchange("c1", "cubic", "trapez"), None, "exchange_icon trapez c1/trapez cubic c1/cubic conf"),
        (act.Remove("c1", ("a", "b")), None, "delete_icon a,b c1/a,c1/b Untitled-1 c1 conf"),
        (act.Move("c1", {"a": (1, 2)}, {"Q": (3, 4)}), None, "move_icon a,Q c1/a,c1/Q Untitled-1 c1 conf"),
        (act.Move("c1", {}, {"Q": (3, 4)}), None, "move_icon Q c1/Q Untitled-1 c1 conf"),
        (act.Paste("c1", 0, 0), ("a", "b"), "paste_icon a,b c1/a,c1/b Untitled-1 c1 conf"),
        (act.Group("c1", "arm", ("a", "b")), None, "group_icon a,b c1/a,c1/b arm c1/arm conf"),
        (act.Ungroup("c1", "arm"), None, "ungroup_icon arm c1/arm Untitled-1 c1 conf"),
        (act.SaveGroup("c1", "arm"), "/lab/conf/arm.conf", "save_group arm c1/arm Untitled-1 c1 conf"),
        (act.Insert("c1", "arm", 0, 0), ("a", "b"), "insert_conf a,b c1/a,c1/b Untitled-1 c1 conf"),
        (act.TurnGroup("c1", "arm", True), None, "turn_on_group arm c1/arm Untitled-1 c1 conf"),
        (act.TurnGroup("c1", "arm", False), None, "turn_off_group arm c1/arm Untitled-1 c1 conf"),
        (act.Show("c1", ("Q",), False), None, "hide_locus Q c1/Q Untitled-1 c1 conf"),
        (act.Turn("c1", ("a",), True), None, "turn_on_task a c1/a Untitled-1 c1 conf"),
        (act.Turn("c1", ("a",), False), None, "turn_off_task a c1/a Untitled-1 c1 conf"),
        (act.Touch("cell", "panic", True), None, "press_part panic cell/panic cell cell main"),
        (act.Touch("cell", "panic", False), None, "let_go_part panic cell/panic cell cell main"),
        (act.Alias("pd", "Q", "Q_2", "c1"), None, "set_alias pd pd Q=Q_2 Q lexi"),
        (act.LibraryRate("pd", 5.0), None, "set_rate pd pd none 0 lexi"),
        (act.OpenLibrary("/lab"), None, "open_lexi /lab /lab none 0 lexi"),
        (act.Prefer({"min_size": 3, "main": {}}), None, "set_preference min_size,main min_size,main none 0 main"),
        (act.Press("tea"), None, "press_button tea tea none 0 button"),
        (act.Stop(), None, "stop none 0 none 0 main"),
        (act.Draft("c2"), None, "try_job move c2 none 0 dict"),
        (act.MakeJob("c2", "7"), None, "new_job move c2 none 0 dict"),
        (act.MakeTarget("", "Joint object", (("1", "2"), ("3",)), ""), None, "new_target none 0 none 0 dict"),
        (act.OpenRecording("/r/run.mcap"), "/r/run.mcap", "open_recording /r/run.mcap /r/run.mcap none 0 main"),
        (act.Note("select_icon", "pd", "x", "y", "z", "lexi"), None, "select_icon pd x y z lexi"),
        (act.Note(""), None, "none none 0 none 0 root"),
    ],
)
def test_an_act_says_what_it_touches(wish, value, rest):  # R-H01
    assert columns(wish, value)[1:] == tuple(rest.split())


def test_what_was_refused_is_marked():  # R-H01
    assert columns(act.Place("c2", "pd", 3, 4), no=No(Reason.plain("no")))[1] == "try_insert_icon"
    assert columns(act.Open("move"), no=No(Reason.plain("no")))[1:4] == ("try_open_conf", "move", "0")
    assert columns(act.Draft("c2"), no=No(Reason.plain("no")))[1] == "try_job"


def test_every_act_of_a_user_has_its_event_and_what_a_page_asks_by_itself_has_none():  # R-H01
    assert set(_EVENTS) == set(get_args(act.AnyAct)) - OF_THE_PAGE - {act.Note}
    assert set(_EVENTS) <= set(HANDLERS) and set(HANDLERS) - set(_EVENTS) <= OF_THE_PAGE | {act.Note}
    assert entries(act.Watch(), ActAnswer(), NAMES) == ()


def filled(kind: Any, mark: str, default: Any = None) -> Any:
    """A value of an act's field in which this mark can be found again, other than it would be without a word."""
    if get_origin(kind) is UnionType:
        return filled(next(part for part in get_args(kind) if part is not NoneType), mark)
    if get_origin(kind) is Literal:
        return next(word for word in get_args(kind) if word != default)
    if get_origin(kind) is tuple:
        parts = [part for part in get_args(kind) if part is not Ellipsis]
        return tuple(filled(part, mark) for part in parts)
    if get_origin(kind) is dict:
        of_key, of_value = get_args(kind)
        return {filled(of_key, mark): filled(of_value, mark)}
    plain = {str: mark, int: 77, float: 7.5, bool: default is not True, Any: mark}
    return plain[kind]


@pytest.mark.parametrize("kind", sorted(_EVENTS, key=lambda kind: kind.__name__))
def test_the_lines_of_an_act_say_every_word_and_number_that_was_given_with_it(kind):  # R-H01
    hints = get_type_hints(kind)
    fields = {
        field.name: filled(hints[field.name], f"word_{field.name}", field.default)
        for field in msgspec.structs.fields(kind)
    }
    lines = [line.columns(1.0) for line in entries(kind(**fields), ActAnswer(), {})]
    assert all(len(line) == 7 and "" not in line and not any("\t" in word for word in line) for line in lines)
    text = "\n".join("\t".join(line) for line in lines)
    for name in fields.keys() - UNTOLD:
        has_name = name in PLACES or f'"{name}":' in text
        assert has_name or f"word_{name}" in text, name
    assert not any(f"word_{name}" in text for name in UNTOLD)


@pytest.mark.parametrize(
    ("wish", "values"),
    [
        (act.Rate("c2", "pd", 500.0), '{"hz":500.0}'),
        (act.Local("pd", (("STIFF", ("0.5", "a  b")),), "c2"), '{"lines":[["STIFF",["0.5","a  b"]]]}'),
        (act.WriteVariable("c2", "LAMP", (1.0,)), '{"values":[1.0]}'),
        (act.Answer("c2", "jmove", "0 1 2"), '{"line":"0 1 2"}'),
        (act.Move("c2", {"pd": (3, 4)}), '{"tasks":{"pd":[3,4]}}'),
        (act.RemoveFlow("a1", "1"), '{"flow":"1"}'),
        (act.Close("c2", discards=True), '{"discards":true}'),
    ],
)
def test_what_was_typed_chosen_and_dragged_stands_behind_the_act(wish, values):  # R-H01
    first, second = (line.columns(1.0) for line in entries(wish, ActAnswer(), NAMES))
    assert second[1] == "enter_values" and second[3] == values
    assert second[4:] == (first[2], first[3], first[6])


def test_an_act_with_nothing_but_what_it_is_about_has_one_line():  # R-H01
    assert len(entries(act.Remove("c2", ("pd", "cubic")), ActAnswer(), NAMES)) == 1
    assert len(entries(act.Save("c2"), ActAnswer(), NAMES)) == 1


def test_a_long_text_is_told_by_its_length_and_its_digest():  # R-H01
    _, values = entries(act.MakeJob("c2", "7" * 4096), ActAnswer(), NAMES)
    text = "\t".join(values.columns(1.0))
    assert '"length":4096' in text and len(text) < 200
    _, other = entries(act.MakeJob("c2", "8" * 4096), ActAnswer(), NAMES)
    assert values != other


def test_what_was_taken_back_is_named(tmp_path):  # R-H01, R-X10
    label = Reason.of("run.nothing_to_undo")
    assert columns(act.Undo("c2"), label)[1:] == ("undo", "move", "c2", label.text, label.key, "conf")
    assert columns(act.Redo("c2"), label)[1:] == ("redo", "move", "c2", label.text, label.key, "conf")


def test_a_text_can_never_break_a_line():  # R-H01
    assert DiaryEntry("a\tb\nc", " ", "\n").columns(0.0) == ("0.000", "a b c", "none", "0", "none", "0", "root")


def test_a_token_is_never_written():  # R-H01
    lines = entries(act.Connect("c1", "ws://robot", "secret"), ActAnswer(), NAMES)
    assert not any("secret" in word for line in lines for word in line.columns(0.0))
