from typing import get_args

import pytest

from onika.link.caller import Role
from onika.web.access.act_rights import LEAST, WATCHING, least, refusal
from onika.web.access.entrance import OWNER, Visitor
from onika.wire import act


def test_every_act_stands_in_one_row():  # R-F10; the rows themselves are tried by the contract
    assert set(LEAST) == set(get_args(act.AnyAct))


def test_a_watcher_watches_and_stops():  # R-F10
    watcher = Visitor("wil", Role.VIEWER)
    assert not refusal(watcher, act.Stop())
    assert not refusal(watcher, act.Watch())
    reason = refusal(watcher, act.Run("a1"))
    assert (reason.key, reason.args) == ("desk.only_watch_and_stop", {"user": "wil"})
    assert act.Stop in WATCHING


@pytest.mark.parametrize(
    ("plain", "more"),
    [
        (act.Connect("c1"), act.Connect("c1", "ssh://robot")),
        (act.Connect("c1"), act.Connect("c1", token="t")),
        (act.AddStation(name="a"), act.AddStation("ssh://robot")),
        (act.Run("a1"), act.Run("a1", saves_unsaved=True)),
        (act.Close("c1"), act.Close("c1", discards=True)),
        (act.LetGo("c1", "x"), act.LetGo("c1", "x", discards=True)),
    ],
)
def test_what_starts_a_program_or_throws_work_away_is_a_programmers(plain, more):  # R-F10
    assert (least(plain), least(more)) == (Role.OPERATOR, Role.PROGRAMMER)


def test_what_stands_in_no_row_is_the_owners():
    assert least(object()) is Role.OWNER


def test_whoever_sits_at_this_machine_may_everything():
    assert not any(refusal(OWNER, kind) for kind in (act.StartAnew(), act.SetButton("a", "b"), act.Stop()))
    denied = refusal(Visitor("pro", Role.PROGRAMMER), act.StartAnew())
    assert (denied.key, denied.args["least"]) == ("desk.act_of_role", "owner")
