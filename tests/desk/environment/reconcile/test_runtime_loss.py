import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.reconcile.runtime_loss import lost, with_loads
from onika.model.task import Task
from onika.wire import act
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))


def test_a_lost_runtime_leaves_the_layout_and_no_state(duet):  # R-E10
    doc, plain = duet.connected("a"), duet.new()
    duet.do(act.Toggle(doc, "a"))
    duet.environment.become(lambda model: lost(model, Reason.plain("it was killed")))
    tree = duet.environment.tree
    assert tree.runtime.state == "lost" and str(tree.runtime.text) == "it was killed" and tree.runtime.units == {}
    assert tree.documents[doc].connection == "lost" and tree.documents[doc].tasks["a"].state == ""
    assert tree.documents[plain].connection == "none"
    assert str(duet.says[-1].text) == "The runtime has ended. Run starts a new one."
    duet.do(act.Remove(doc, ("a",)))
    duet.do(act.Undo(doc))


def test_connecting_again_merges_with_what_runs_there_then(duet):  # R-E10, R-C12
    doc = duet.connected("a")
    duet.environment.become(lambda model: lost(model, Reason.plain("it was killed")))
    duet.runtime = LiveRuntime()
    duet.do(act.Connect(doc))
    assert duet.state(doc, "a") == "OFF" and duet.document(doc).live.subsystem == "Untitled-1"


def test_what_a_runtime_printed_last_is_told_at_its_side_and_nowhere_else(tmp_path):  # R-E10, R-X01
    play = RunFixture(tmp_path)
    play.run(play.open([job("aC")]))
    printed = Reason.of("link.printed_last", output="Traceback (most recent call last):")
    play.lose(Reason.of("link.runtime_gone", why="it ended", how=NOTHING, printed=printed, kept=NOTHING))
    assert not any("Traceback" in str(say.text) for say in play.says) and "Traceback" not in str(play.view.cause)
    assert "Traceback" in str(play.environment.tree.runtime.text)


def test_loads_are_shown_and_only_what_has_changed(duet):  # R-A11
    duet.connected("a")
    model = with_loads(duet.environment.model, {"rt0": 0.5012}, {}).model
    assert model.runtime.units["rt0"].load == 0.5 and model.runtime.units["rt1"].load == 0.25
    assert with_loads(model, {"rt0": 0.4999}, {}).model is model


def test_what_runs_is_aborted_and_says_so_once(tmp_path):  # R-E10
    play = RunFixture(tmp_path)
    play.run(play.open([job("aC")]))
    play.lose("the cable")
    assert play.view.state == "over" and not play.view.is_completed
    assert [str(say.text) for say in play.says if "aborted" in str(say.text)] == [
        "play was aborted after 0 actions: the runtime is lost: the cable"
    ]
    play.lose("again")
    assert str(play.view.cause) == "the runtime is lost: the cable"


def test_a_run_whose_runtime_was_killed_shows_its_last_seconds(tmp_path):  # R-X05, R-E10
    play = RunFixture(tmp_path)
    play.run(play.open([job("aC")]))
    kept = Reason.of("link.black_box", path="/state/black-boxes/a-1.mcap")
    play.lose(Reason.of("link.runtime_gone", why="it ended", how=NOTHING, printed=NOTHING, kept=kept))
    assert play.view.black_box == "/state/black-boxes/a-1.mcap"


def test_a_configuration_whose_runtime_was_killed_shows_its_last_seconds(duet):  # R-X05, R-E10
    doc = duet.connected("a")
    kept = Reason.of("link.black_box", path="/state/black-boxes/a-1.mcap")
    gone = Reason.of("link.runtime_gone", why="it ended", how=NOTHING, printed=NOTHING, kept=kept)
    duet.environment.become(lambda model: lost(model, gone))
    assert duet.environment.tree.documents[doc].black_box == "/state/black-boxes/a-1.mcap"
