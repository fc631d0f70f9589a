import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.reconcile.watches import Watch, keys_of
from onika.model.lifecycle import State
from onika.wire import act, live
from onika.wire.view import Remedy


@pytest.fixture
def play(tmp_path):
    play = RunFixture(tmp_path)
    play.do(act.OpenLibrary(str(play.files.path)))
    play.app = play.open([job("aC"), job("bC")])
    play.run(play.app)
    play.alive()
    return play


@pytest.fixture
def doc(play):
    """The configuration of its first action, which looks into the run."""
    doc = play.do(act.Open(str(play.files.path / "conf" / "aC.conf")))
    play.do(act.Connect(doc, subsystem="flow0"))
    return doc


def shown(play, doc):
    return play.environment.tree.documents[doc]


def test_a_configuration_shows_the_states_of_the_run_that_it_looks_into(play, doc):  # R-C15, R-C18, R-E11
    view = shown(play, doc)
    assert (view.connection, view.subsystem, view.application, view.has_ended) == ("live", "flow0", "play", False)
    assert (view.tasks["a"].state, view.holder, view.is_held_here) == ("OFF", "you", True)
    play.turned("a", State.ON)
    view = shown(play, doc)
    assert view.tasks["a"].state == "ON" and not view.is_dirty and play.document(doc).live is None


def test_its_values_and_figures_are_those_of_the_run(play, doc):  # R-C14, R-E11
    model = play.environment.model
    assert "flow0/A" in Watch(frozenset((f"{doc}/A",))).attend(model).readings
    assert f"{doc}/A" in keys_of(model, "flow0/A")


@pytest.mark.parametrize(
    "change",
    [
        lambda doc: act.Place(doc, "b", 10, 10),
        lambda doc: act.Remove(doc, ("a",)),
        lambda doc: act.Turn(doc, ("a",), True),
        lambda doc: act.Toggle(doc, "a"),
        lambda doc: act.Clear(doc, "a"),
        lambda doc: act.Rate(doc, "a", 50.0),
    ],
)
def test_nobody_changes_by_hand_what_belongs_to_a_run(play, doc, change):  # R-C15, R-X12
    before, asked = play.document(doc), len(play.carried_out)
    no = play.no(change(doc))
    assert "aC shows flow0 of play, held by you" in str(no.reason)
    assert no.remedies == (Remedy(no.remedies[0].label, act.Disconnect(doc)),)
    assert play.document(doc) is before and len(play.carried_out) == asked


def test_looking_asks_nothing_of_the_runtime_but_what_there_is(play):  # R-C15
    doc = play.do(act.Open(str(play.files.path / "conf" / "aC.conf")))
    asked = len(play.carried_out)
    play.do(act.Connect(doc, subsystem="flow0"))
    play.do(act.Move(doc, {"a": (40, 40)}))
    play.do(act.Close(doc, discards=True))
    assert {type(message) for message in play.carried_out[asked:]} <= {live.Survey}


def test_when_the_run_ends_it_says_so_and_is_a_plain_configuration_again(play, doc):  # R-E11, R-C15
    play.turned("a", State.ON)
    play.runtime.finish("play")
    play.end()
    view = shown(play, doc)
    assert (view.connection, view.has_ended, view.tasks["a"].state) == ("none", True, "")
    play.do(act.Remove(doc, ("a",)))
    play.do(act.Disconnect(doc))
    assert (shown(play, doc).application, shown(play, doc).has_ended) == ("", False)


def test_a_run_of_nobody_can_be_taken_over_from_there(play, doc):  # R-X12
    play.runtime.perform("play", "flow0", (), "")
    play.do(act.Company())
    no = play.no(act.Toggle(doc, "a"))
    assert "which nobody holds" in str(no.reason)
    assert [remedy.act for remedy in no.remedies] == [act.Disconnect(doc), act.Take(subsystem="flow0")]


def test_two_configurations_look_into_one_flow(play, doc):  # R-C27
    other = play.do(act.Open(str(play.files.path / "conf" / "bC.conf")))
    play.do(act.Connect(other, subsystem="flow0"))
    play.turned("b", State.ON)
    assert (shown(play, doc).tasks["a"].state, shown(play, other).tasks["b"].state) == ("OFF", "ON")
    assert set(keys_of(play.environment.model, "flow0/B")) >= {f"{doc}/B", f"{other}/B", "@flow0/B"}


def test_memory_and_readings_of_a_run_are_looked_at_from_there(play, doc):  # R-A12, R-C15
    play.runtime.variables["flow0"] = {"A": 2.5}
    assert play.do(act.CheckMemory(doc)) == ()
    assert "flow0" in play.do(act.LogReadings(doc))
    assert live.Check("flow0") in play.carried_out and live.Read("flow0") in play.carried_out
