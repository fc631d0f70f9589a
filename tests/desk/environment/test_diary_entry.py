from typing import get_args

import pytest

from onika.desk.environment.diary_entry import _EVENTS, HEADER, DiaryEntry, entry
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.outcome.outcome import No
from onika.wire import act
from onika.words.reason import Reason

NAMES = {"c1": "Untitled-1", "c2": "move"}


def columns(wish, value=None, no=None):
    return entry(wish, ActAnswer(value, no), NAMES).line(770909683.25).split("\t")


def test_a_line_has_the_seven_columns_of_the_thesis():  # R-H01, §E.2
    assert columns(act.Place("c2", "pd", 3, 4)) == ["770909683.250", "insert_icon", "pd", "c2/pd", "move", "c2", "conf"]
    assert len(HEADER.split("\t")) == 7


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
    assert columns(wish, value)[1:] == rest.split()


def test_what_was_refused_is_marked():  # R-H01
    assert columns(act.Place("c2", "pd", 3, 4), no=No(Reason.plain("no")))[1] == "try_insert_icon"
    assert columns(act.Open("move"), no=No(Reason.plain("no")))[1:4] == ["try_open_conf", "move", "0"]
    assert columns(act.Draft("c2"), no=No(Reason.plain("no")))[1] == "try_job"


def test_every_act_of_a_user_has_its_event_and_what_a_page_asks_by_itself_has_none():  # R-H01
    of_the_page = {act.ListSets, act.LoadModule, act.Watch, act.Scene, act.Peek, act.Seats, act.WhatIf, act.FindWorlds}
    of_the_page |= {act.Company, act.Recordings, act.Glance, act.Course, act.RecordedScene, act.SampleVariables}
    assert set(_EVENTS) == set(get_args(act.AnyAct)) - of_the_page - {act.Note}
    assert entry(act.Watch(), ActAnswer(), NAMES) is None


def test_a_text_can_never_break_a_line():  # R-H01
    assert DiaryEntry("a\tb\nc", " ", "\n").line(0.0).split("\t") == [
        "0.000",
        "a b c",
        "none",
        "0",
        "none",
        "0",
        "root",
    ]


def test_a_token_is_never_written():  # R-H01
    assert "secret" not in entry(act.Connect("c1", "ws://robot", "secret"), ActAnswer(), NAMES).line(0.0)
