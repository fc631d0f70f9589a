import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import Laboratory, job
from onika.wire import act, live

TWIN = "MODULE b\nDESC a twin\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR E\nTASKTYPE periodic\nFREQ 10"


@pytest.fixture
def play(tmp_path):
    files = Laboratory(tmp_path)
    files.module("rival", "# rival\n")
    files.plain_task("rival", writes="D", local="DEVICE arm\n")
    files.task("twin", TWIN)
    return RunFixture(tmp_path)


def reason(play, *tasks):
    play.connected(*tasks)
    no = play.answer(act.Run(play.open([job("aC"), job("bC")]))).no
    return "" if no is None else str(no.reason)


@pytest.mark.parametrize(("lives", "why"), [("a", "its name"), ("twin", "its module"), ("rival", "its device")])
def test_what_shares_a_name_a_module_or_a_device_is_in_the_way(play, lives, why):  # reading 30
    assert f"lives already: {lives} of Untitled-1." in reason(play, lives, "c"), why


def test_what_shares_nothing_lives_on(play):  # reading 30
    assert reason(play, "c") == ""
    assert play.carried(live.Close) == []


def test_a_subsystem_that_nobody_shows_is_named(play):  # reading 30
    lower = play.connected("a")
    play.do(act.New())
    play.do(act.Close(lower, discards=True, alive="leave"))
    no = play.answer(act.Run(play.open([job("aC")]))).no
    assert "a in subsystem Untitled-1" in str(no.reason)
