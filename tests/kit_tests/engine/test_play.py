import pytest

from kit.engine.play import Play
from kit.plans import build
from onika.engine.news import Run, Spawned, TurnedOn
from onika.engine.orders import Began, Launch, Spawn, Switch
from onika.wire.steer import Pass, Pause


def play():
    return Play(build.engine([build.job("move", trigger="move")]))


def test_a_story_that_is_true_is_true():
    story = (
        play()
        >> Run() << Spawn(0, "move")
        >> Spawned(0, "move") << [Switch(0, (), (Launch("move", "", 100.0),)), Began(0, 0)]
    )  # fmt: skip
    assert story


def test_an_order_that_the_engine_did_not_give_is_named_with_the_story_so_far():
    with pytest.raises(AssertionError) as raised:
        play() >> Run() << Spawn(0, "grip")
    story, end = str(raised.value).split("and then")
    assert ">> Run()" in story
    assert end.split("\n")[1:] == ["expected Spawn(flow=0, task='grip')", "found    Spawn(flow=0, task='move')"]


def test_an_order_that_is_expected_and_does_not_come_is_named():
    with pytest.raises(AssertionError, match="found    no order"):
        play() >> Run() << Spawn(0, "move") << Spawn(0, "grip")


def test_an_order_that_is_not_told_is_named_at_the_next_news():
    with pytest.raises(AssertionError, match="expected no further order\nfound    Spawn"):
        play() >> Run() >> Run()


def test_an_order_that_is_not_told_is_named_at_the_end():
    with pytest.raises(AssertionError, match="expected no further order\nfound    Spawn"):
        bool(play() >> Run())


def begun():
    job = build.job("move", trigger="move")
    switch = Switch(0, (), (Launch("move", "", 100.0),))
    return (
        Play(build.engine([job, job]))
        >> Run() << Spawn(0, "move")
        >> Spawned(0, "move") << [switch, Began(0, 0)]
        >> TurnedOn(0, "move")
    )  # fmt: skip


def test_what_is_refused_is_refused_with_its_reason():
    assert begun().refuses(Pass("0"), "expected flow 0 to be waiting")
    with pytest.raises(AssertionError, match=r"expected .* refused: because\nfound    expected flow 0 to be waiting"):
        begun().refuses(Pass("0"), "because")
    with pytest.raises(AssertionError, match="found    no refusal"):
        begun().refuses(Pause("0"), "because")


def test_the_place_and_the_cases_of_a_flow_can_be_asked_once_all_is_told():
    play = begun()
    assert (play.position(0).action, [case.task for case in play.cases(0)]) == (0, ["move"])
    untold = begun() >> Pause("0")
    for ask in (untold.position, untold.cases):
        with pytest.raises(AssertionError, match="expected no further order\nfound    Moved"):
            ask(0)
