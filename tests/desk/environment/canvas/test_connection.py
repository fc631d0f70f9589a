import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.reconcile.joining import connected
from onika.desk.environment.reconcile.runtime_loss import lost
from onika.model.task import Task
from onika.wire import act, live, request
from onika.wire.runtime_standing import Standing, SubsystemStanding
from onika.wire.view import ShowConnect
from onika.words.reason import Reason

TASKS = (
    *(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b", "c")),
    Task("rival", "rival", outvar=("A",), frequency=10.0),
)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def running(duet, *names, subsystem="main"):
    """Tasks that somebody else has brought to life, ON."""
    from onika.desk.environment.reconcile.task_plan import birth
    from onika.model.configuration import Placed

    born = [birth(Placed(name), duet.environment.model.libraries, ()) for name in names]
    on = tuple(live.Turn(name) for name in names)
    duet.runtime.ask(live.Change(subsystem, spawn=tuple(task.task for task in born), on=on))
    list(duet.runtime.events(0.0))


def test_a_fresh_runtime_gets_everything_that_is_placed_off(duet):  # R-C12, Equation (1)
    doc = duet.connected("a", "b")
    document = duet.document(doc)
    assert {name: duet.state(doc, name) for name in document.content.names} == {"a": "OFF", "b": "OFF"}
    assert document.live.subsystem == "Untitled-1" and document.live.is_held_here
    assert duet.environment.tree.runtime.state == "linked" and duet.environment.tree.runtime.is_virtual
    assert str(document.history.last.label) == "placing b"  # connecting has changed nothing on the canvas


def test_what_runs_wins_and_comes_onto_the_canvas_as_one_step(duet):  # R-C12, Equation (4)
    running(duet, "rival", "c")
    doc = duet.new("a", "b", "c")
    assert str(duet.do(act.Connect(doc))) == "connected with main"
    document = duet.document(doc)
    assert document.content.names == ("b", "c", "rival")
    assert document.content.wanted == {"c": True, "rival": True, "b": False}
    assert str(document.history.last.label) == "connecting"
    assert any(str(say.text).startswith("a leaves the canvas: ") for say in duet.says)
    duet.do(act.Undo(doc, confirmed=True))
    assert duet.document(doc).content.names == ("a", "b", "c")
    assert set(duet.runtime.lives["main"]) == {"a", "b", "c"}


def test_newcomers_stand_where_nothing_stands(duet):  # R-C12
    running(duet, "a", "b", "c")
    doc = duet.new()
    duet.do(act.Connect(doc))
    spots = [(placed.x, placed.y) for placed in duet.document(doc).content.configuration.placed]
    assert len(set(spots)) == 3


def test_a_running_tasks_rate_and_unit_win(duet):  # reading 4
    running(duet, "a")
    duet.runtime.ask(live.Change("main", rates=(("a", 50.0),)))
    doc = duet.new("a")
    duet.do(act.Connect(doc))
    placed = duet.document(doc).content.placed("a")
    assert (placed.frequency, placed.rtpu) == (50.0, "rt0")


def test_a_document_goes_to_the_subsystem_of_its_name_or_to_the_only_one(duet):  # R-C18
    running(duet, "a", subsystem="left")
    running(duet, "b", subsystem="Untitled-1")
    first, second = duet.new(), duet.new()
    duet.do(act.Connect(first))
    duet.do(act.Connect(second))
    assert duet.document(first).live.subsystem == "Untitled-1"
    assert duet.document(second).live.subsystem == "left"
    third = duet.new()
    refused = duet.answer(act.Connect(third, subsystem="left")).no
    assert "connected with subsystem left" in str(refused.reason) and duet.document(third).live is None


def test_a_new_document_gets_a_subsystem_that_no_other_has(duet, tmp_path):  # R-C18
    subsystems = []
    for name in ("first", "second", "third"):
        doc = duet.connected("a")
        subsystems.append(duet.document(doc).live.subsystem)
        duet.do(act.Save(doc, name=name, base=str(tmp_path)))  # the next one is Untitled-1 again
    assert subsystems == ["Untitled-1", "Untitled-1-2", "Untitled-1-3"]


def test_a_subsystem_in_which_an_application_runs_is_proposed_to_nobody(duet):  # reading 30
    duet.runtime.perform("assemble", "Untitled-1", ())
    doc = duet.connected("a")
    assert duet.document(doc).live.subsystem == "Untitled-1-2"


@pytest.mark.parametrize("name", ["1st", "a b", "ü"])
def test_what_is_no_name_of_a_subsystem_is_refused_beside_its_field(duet, name):  # R-X01
    doc = duet.new()
    assert "subsystem" in duet.no(act.Connect(doc, subsystem=name)).fields


def test_connecting_twice_is_refused_with_the_way_out(duet):
    doc = duet.connected()
    assert duet.no(act.Connect(doc)).remedies[0].act == act.Disconnect(doc)


def test_where_there_is_no_runtime_the_session_goes_on_unconnected(duet):  # R-C18
    duet.rebuffs = {live.Survey: request.Refused(Reason.plain("nobody is there"))}
    doc = duet.new("a")
    refused = duet.answer(act.Connect(doc)).no
    assert "nobody is there" in str(refused.reason) and refused.remedies[0].show == ShowConnect()
    assert duet.document(doc).live is None
    assert (
        duet.environment.tree.runtime.state == "lost" and str(duet.environment.tree.runtime.text) == "nobody is there"
    )
    duet.do(act.Remove(doc, ("a",)))


def test_an_application_that_runs_is_not_disturbed(duet):  # reading 30
    home = SubsystemStanding("main", "anna#2", "assemble", ())
    duet.rebuffs = {live.Survey: Standing((home,), (), (), True, False, 0.0)}
    doc = duet.new("a")
    assert str(duet.do(act.Connect(doc, subsystem="main"))) == "it shows main of assemble"
    assert duet.document(doc).live is None and {type(message) for message in duet.carried_out} == {live.Survey}


def test_whoever_may_not_take_it_watches(duet):  # R-X12
    running(duet, "a")
    duet.runtime._holders["main"] = "anna#2"
    duet.rebuffs = {live.Take: request.Refused(Reason.plain("subsystem main is held by anna#2"))}
    doc = duet.new("b")
    duet.do(act.Connect(doc))
    view = duet.environment.tree.documents[doc]
    assert view.holder == "anna#2" and not view.is_held_here and set(duet.runtime.lives["main"]) == {"a"}
    assert "you can only watch" in str(duet.says[-1].text)


def test_who_has_no_code_is_left_out_and_the_others_live(duet, tmp_path):  # R-C01
    (tmp_path / "module" / "a.py").unlink()
    doc = duet.connected("a", "b")
    assert {name: duet.state(doc, name) for name in ("a", "b")} == {"a": "", "b": "OFF"}
    assert any(str(say.text).endswith("it is left out") for say in duet.says)


def test_a_stopped_runtime_is_connected_with_and_nobody_is_born(duet):  # law 27
    duet.runtime.is_stopped = True
    doc = duet.connected("a")
    assert duet.state(doc, "a") == "" and duet.environment.tree.documents[doc].connection == "live"
    assert "nothing is spawned" in str(duet.says[-1].text)


def test_leaving_keeps_the_layout_and_what_runs(duet):  # R-C18
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    duet.do(act.Disconnect(doc))
    view = duet.environment.tree.documents[doc]
    assert view.connection == "none" and view.tasks["a"].state == "" and "a" in view.tasks
    assert duet.runtime.lives["Untitled-1"]["a"].state.value == "ON"
    assert str(duet.no(act.Disconnect(doc)).reason) == "Untitled-1 is not connected"
    duet.do(act.Connect(doc))
    assert duet.state(doc, "a") == "ON"


def test_a_runtime_at_another_address_becomes_a_station_beside_the_first(duet):  # R-C18, R-F02
    doc = duet.connected("a")
    other = duet.new("a")
    duet.do(act.Connect(other, url="wss://elsewhere.example:7994"))
    assert duet.environment.tree.stations["elsewhere"].address == "wss://elsewhere.example:7994"
    assert (duet.document(doc).station, duet.document(other).station) == ("", "elsewhere")
    third = duet.new()
    duet.do(act.Connect(third, url="wss://elsewhere.example"))
    assert duet.document(third).station == "elsewhere" and len(duet.environment.tree.stations) == 1


def test_one_that_is_launched_connected_is_merged_at_once(duet):  # R-C18
    doc = duet.new("a")
    duet.runtime.ask(live.Take("main"))
    standing = duet.runtime.ask(live.Survey())
    done = connected(duet.environment.model, doc, standing, me="you")
    assert done.model.documents[doc].live.state_of("a") == "SPAWNING"
    assert [type(order.asked) for order in done.orders] == [live.Change, live.Describe]


@pytest.mark.parametrize("wish", [act.Connect("c9"), act.Disconnect("c9")])
def test_a_document_that_is_closed_is_not_connected(duet, wish):
    assert str(duet.no(wish).reason) == "this configuration is no longer open"


def test_a_runtime_elsewhere_that_was_lost_is_looked_for_where_it_was(duet):  # R-E10, R-C18
    doc = duet.new("a")
    duet.do(act.Connect(doc, url="ws://lab:7994", token="secret"))
    duet.environment.become(lambda model: lost(model, Reason.plain("the cable")))
    duet.do(act.Connect(doc))
    assert [order.reach.url for order in duet.orders if order.reach] == ["ws://lab:7994", "ws://lab:7994"]
    assert duet.environment.tree.runtime.address == "ws://lab:7994"


def test_where_another_runtime_cannot_be_reached_the_first_stays_as_it_is(duet):  # R-C18
    doc = duet.new()
    duet.do(act.Connect(doc))
    duet.do(act.Disconnect(doc))
    duet.rebuffs = {live.Survey: request.Refused(Reason.plain("nobody is there"))}
    assert duet.answer(act.Connect(doc, url="ws://lab:7994")).no
    assert duet.environment.tree.runtime.state == "linked" and not duet.environment.tree.stations


def test_a_second_runtime_is_connected_while_an_application_runs_on_the_first(tmp_path):  # R-C18, R-F02
    play = RunFixture(tmp_path)
    doc = play.open([job("aC")])
    play.run(doc)
    play.do(act.Connect(play.new("c"), url="wss://there.example"))
    assert play.environment.tree.run.state == "running" and list(play.environment.tree.stations) == ["there"]
