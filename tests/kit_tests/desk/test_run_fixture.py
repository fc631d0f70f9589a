import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job


def test_a_play_runs_as_the_test_says(tmp_path):
    play = RunFixture(tmp_path)
    doc = play.open([job("aC"), job("bC")])
    with pytest.raises(AssertionError, match="nothing runs"):
        play.view  # noqa: B018 - it is looked at
    play.run(doc)
    play.began(0)
    play.done(0)
    with pytest.raises(AssertionError, match="no action 7"):
        play.began(7)
    play.end()
    assert play.view.is_completed and (play.view.done, play.view.of) == (1, 2)
