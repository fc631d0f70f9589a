import json
from pathlib import Path
from typing import get_args

import msgspec
import pytest
from hypothesis import given, settings, strategies as st

from kit.wire.struct_values import values_of
from onika.desk.environment.diary_record import LABS, LARGEST, DiaryRecord, event_of, place_names, reply_of
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.outcome.outcome import No
from onika.store.shipped import shipped
from onika.wire import act, event, holding, request
from onika.words.reason import Reason

PLACES = place_names((Path("/home/anna/lab"), shipped() / "boxes", Path("/home/anna/lab/inner")))


@pytest.fixture
def record():
    return DiaryRecord("aa", PLACES, "/home/anna")


def test_folders_of_the_search_path_are_told_by_their_number(record):  # R-H08
    command = act.Open("/home/anna/lab/conf/move.conf")
    text = record.text(3, record.of_act(command, "me", ActAnswer("c1")))
    assert json.loads(text)["act"]["path"] == "{base0}/conf/move.conf"
    assert record.nameless("/home/anna/lab/inner/conf") == "{base1}/conf"
    assert record.nameless(f"{shipped()}/boxes/appl") == f"{LABS}/boxes/appl"
    assert record.nameless("/home/anna/laboratory /home/anna/x") == "~/laboratory ~/x"


def test_an_act_stands_whole_with_its_answer_and_a_number_for_who_did_it(record):  # R-H08
    first = record.of_act(act.Place("c2", "pd", 3, 4), "anna 1", ActAnswer())
    other = record.of_act(act.New(), "bert 2", ActAnswer("c1"))
    refused = record.of_act(act.New(), "anna 1", ActAnswer(no=No(Reason.of("run.nothing_to_undo"))))
    assert first == {"act": {"t": "Place", "doc": "c2", "task": "pd", "x": 3, "y": 4}, "by": 0}
    assert other["by"] == 1 and other["value"] == "c1"
    assert refused["by"] == 0 and refused["no"] == "run.nothing_to_undo"


def test_no_secret_and_no_name_is_written(record):  # R-H01
    for command in (
        act.Connect("c1", "wss://anna:secret@robot", "secret"),
        act.AddStation("wss://robot", "secret", "b"),
        act.BrowseLibrary("https://lib", "anna", "secret"),
        act.Hand("c1", "anna@robot"),
    ):
        text = record.text(0, record.of_act(command, "anna 1", ActAnswer()))
        assert "secret" not in text and "anna" not in text, text
    held = record.of_message("", "", event.Held("main", "anna@robot 1"))
    again = record.of_message("", "", event.Held("other", "anna@robot 1"))
    assert held["event"]["holder"] == again["event"]["holder"] == "session 2"
    assert record.of_message("", "Sessions", holding.Company("anna", ())) is None
    assert record.of_message("", "", event.Company(())) is None


def test_what_is_very_long_is_told_by_its_length(record):  # R-H08
    text = record.text(1, {"file": "x", "text": "y" * LARGEST})
    assert json.loads(text) == {"s": "aa", "n": 1, "left_out": "file", "bytes": json.loads(text)["bytes"]}
    assert json.loads(text)["bytes"] > LARGEST


@pytest.mark.parametrize("kind", get_args(event.Event), ids=lambda kind: kind.__name__)
@given(data=st.data())
@settings(max_examples=5, deadline=None)
def test_an_event_is_read_as_it_was_written(kind, data):  # R-H08
    message = data.draw(values_of(kind))
    content = DiaryRecord("aa", {}, "").of_message("", "", message)
    if content is not None and not {"Held", "Offered"} & {kind.__name__}:
        assert event_of(json.loads(msgspec.json.encode(content))["event"]) == message


@pytest.mark.parametrize("kind", get_args(request.Response), ids=lambda kind: kind.__name__)
@given(data=st.data())
@settings(max_examples=5, deadline=None)
def test_a_reply_is_read_as_it_was_written(kind, data):  # R-H08
    message = data.draw(values_of(kind))
    content = DiaryRecord("aa", {}, "").of_message("b", "Prepare", message)
    if content is not None and "holder" not in str(content):
        assert content["station"] == "b" and content["to"] == "Prepare"
        assert reply_of(json.loads(msgspec.json.encode(content))["reply"]) == message


def test_what_a_page_only_looks_at_is_not_written(record):  # R-H08
    assert record.of_message("", "Scene", request.Done()) is None
    assert record.of_message("", "Prepare", request.Done()) is not None
