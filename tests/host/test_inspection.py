import pytest

from kit.plans.plan_builder import action
from kit.runtime.live_edits import COUNTER, live_edits_with_tasks
from kit.worlds.rail_world import rail_tasks
from onika.wire import live, reading, request

SECOND = 1_000_000_000


@pytest.fixture
def hand():
    edits = live_edits_with_tasks(("rt0", "rt1"), counter="rt1")
    edits.change(spawn=["source", "user", "counter"], on=["source", "counter"])
    return edits


def shown(hand, session="me"):
    return [(key, value) for who, key, value in hand.asker.server.shown if who == session]


def show(hand, wall_ns):
    hand.asker.program._look.show(wall_ns)


def test_figures_count_since_they_were_last_asked_for(hand):  # R-A17, R-A11
    hand.let_pass(1.0)
    first = hand.figures()
    assert {name: figure.cycle for name, figure in first.items()} == {"source": 101, "user": 0, "counter": 51}
    assert (first["counter"].rtpu, first["counter"].rmod, first["counter"].type) == ("rt1", "counter", "P")
    assert (first["user"].state, first["source"].ref_hz) == ("OFF", 100.0)
    assert 0 < first["source"].least_ms <= first["source"].mean_ms <= first["source"].most_ms
    hand.let_pass(1.0)
    assert {name: figure.cycle for name, figure in hand.figures().items()} == {"source": 100, "user": 0, "counter": 50}
    assert {figure.cycle for figure in hand.figures().values()} == {0}


def test_loads_are_told_of_every_unit(hand):  # R-A11, R-X13
    answer = hand.asker.ask(live.Status())
    assert set(answer.loads) == {"rt0", "rt1"}
    assert answer.overloads == ()


def test_what_there_is_is_told_whole(hand):  # R-C12
    standing = hand.asker.ask(live.Survey())
    assert (standing.is_virtual, standing.is_stopped, standing.worlds) == (True, False, ())
    assert [(unit.name, unit.is_lost) for unit in standing.rtpus] == [("rt0", False), ("rt1", False)]
    (subsystem,) = standing.subsystems
    assert (subsystem.name, subsystem.holder, subsystem.application) == ("s0", "me", "")
    wanted = {task.task.name: (task.state, task.is_wanted_on, task.frequency) for task in subsystem.tasks}
    assert wanted == {"source": ("ON", True, 100.0), "user": ("OFF", False, 100.0), "counter": ("ON", True, 50.0)}


def test_it_names_the_libraries_that_it_supplies(hand):  # R-C19
    hand.asker.server.libraries = ("https://robots.example/arm",)
    assert hand.asker.ask(live.Survey()).libraries == ("https://robots.example/arm",)


def test_a_lost_unit_is_told_as_lost(hand):  # R-E10
    hand.driver.lose("rt1")
    assert [unit.is_lost for unit in hand.asker.ask(live.Survey()).rtpus] == [False, True]
    assert set(hand.asker.ask(live.Status()).loads) == {"rt0"}


def test_an_application_is_told_with_who_began_it(hand):  # R-C12
    hand.shop = rail_tasks()
    hand.asker.ask(request.Prepare(hand.shop.plan([action("mass", "servo")]), ()), "one")
    hand.asker.ask(request.Begin(may_ask=True), "one")
    hand.work()
    holders = {
        subsystem.name: (subsystem.holder, subsystem.application)
        for subsystem in hand.asker.ask(live.Survey()).subsystems
    }
    assert holders == {"flow0": ("one", "test"), "s0": ("me", "")}
    assert hand.asker.ask(live.Survey()).worlds == ("yard",)


def test_variables_are_read_by_name_or_all(hand):  # R-A12
    hand.let_pass(0.1)
    assert hand.values("COUNT") == {"COUNT": 6.0}
    assert set(hand.values()) == {"N", "LEVEL", "ROW", "COUNT"}
    assert hand.values("ROW") == {"ROW": [0.0, 0.0]}


@pytest.mark.parametrize("wish", [live.Read("no"), live.Read("s0", ("NO",)), live.Check("no"), live.Scene("no")])
def test_what_is_not_there_is_not_read(hand, wish):
    assert "no" in str(hand.asker.ask(wish).reason).lower()


def test_memory_that_was_overwritten_is_found(hand):  # R-A12
    assert hand.asker.ask(live.Check("s0")) == live.Findings(())
    hand.asker.program.subsystems.tables["s0"].ring("LEVEL").write(b"\0" * 8)
    hand.let_pass(0.1)
    (finding,) = hand.asker.ask(live.Check("s0")).findings
    assert finding.args["variable"] == "LEVEL"
    assert "task source on rt0 (writes it)" in str(finding)


def test_readings_are_shown_when_they_have_changed_and_it_is_time(hand):
    hand.asker.ask(live.Attend(readings=("s0/COUNT", "s0/NO", "no/COUNT"), hz=10.0))
    show(hand, 10**15)
    assert [key for key, _ in shown(hand)] == ["s0/COUNT"]
    hand.asker.server.shown.clear()
    show(hand, 10**15 + SECOND)
    assert shown(hand) == []
    hand.let_pass(0.1)
    hand.asker.server.shown.clear()
    hand.let_pass(0.1)
    show(hand, 10**15 + 2 * SECOND)
    (key, shape) = shown(hand)[-1]
    assert (key, shape.value) == ("s0/COUNT", hand.values("COUNT")["COUNT"])
    show(hand, 10**15 + 2 * SECOND + SECOND // 20)
    assert len(shown(hand)) == 1


def test_all_variables_of_a_subsystem_are_watched_also_those_that_come_later(hand):
    hand.asker.ask(live.Attend(readings=("s0/*",)))
    hand.task("late", COUNTER.replace("COUNT", "LATE"))
    hand.change(spawn=["late"])
    show(hand, 10**15)
    assert {key for key, _ in shown(hand)} == {f"s0/{name}" for name in ("N", "LEVEL", "ROW", "COUNT", "LATE")}


def test_a_variable_of_another_shape_is_shown_again(hand):  # law 12
    hand.asker.ask(live.Attend(readings=("s0/ROW",)))
    show(hand, 10**15)
    hand.reinit("source", SIZE="3")
    hand.change(on=["user"])
    hand.let_pass(0.1)
    show(hand, 2 * 10**15)
    assert len(shown(hand)[-1][1].value) == 3


def test_poses_of_a_world_are_shown(hand):
    hand.shop = rail_tasks()
    hand.change(spawn=["mass"], subsystem="s1")
    hand.asker.ask(live.Attend(worlds=("yard",)))
    show(hand, 10**15)
    (key, shape) = shown(hand)[-1]
    assert key == "world:yard"
    assert isinstance(shape, reading.Poses)


def test_who_attends_nothing_or_is_gone_is_shown_nothing(hand):
    hand.asker.ask(live.Attend(readings=("s0/*",)), "one")
    hand.asker.ask(live.Attend(readings=("s0/*",)), "two")
    hand.asker.ask(live.Attend(), "two")
    hand.asker.server.gone.append("one")
    hand.asker.program.serve()
    hand.asker.server.shown.clear()
    show(hand, 10**15)
    assert hand.asker.server.shown == []
    assert hand.asker.program._look.due_ns(0) is None


@pytest.mark.parametrize(("hz", "period"), [(0.0, 10.0), (1e9, 1 / 60), (float("inf"), 1 / 60), (2.0, 0.5)])
def test_how_often_is_kept_within_bounds(hand, hz, period):
    hand.asker.ask(live.Attend(readings=("s0/COUNT",), hz=hz))
    show(hand, 10**15)
    assert hand.asker.program._look.due_ns(10**15) == pytest.approx(period * SECOND, rel=1e-6)


def test_no_number_is_no_rate(hand):
    assert isinstance(hand.asker.ask(live.Attend(hz=float("nan"))), request.Refused)
    assert hand.asker.server.attends == {}


def test_pictures_of_a_camera_are_shown_as_long_as_somebody_attends(hand, monkeypatch):  # R-F08
    looked, pictures = [], {"yard:eye": (3, 5, b"file")}
    monkeypatch.setattr(hand.asker.program._look._seen.views, "picture", pictures.get)
    monkeypatch.setattr(hand.asker.program._look._seen.views, "look_only_at", looked.append)
    hand.asker.ask(live.Attend(worlds=("yard:eye", "yard:ear", "yard")))
    show(hand, 10**15)
    show(hand, 2 * 10**15)
    assert shown(hand) == [("world:yard:eye", reading.CameraPicture(5, 3, b"file"))]
    pictures["yard:eye"] = (4, 6, b"next")
    show(hand, 3 * 10**15)
    assert shown(hand)[-1] == ("world:yard:eye", reading.CameraPicture(6, 4, b"next"))
    hand.asker.ask(live.Attend())
    assert looked == [{"yard:eye", "yard:ear"}, set()]


def test_of_a_value_as_long_as_a_picture_only_its_type_is_shown(hand):  # R-F05
    hand.task("film", COUNTER.replace("COUNT", "IMG").replace('"double"', '"byte[120,160,3]"').replace("+ 1.0", "+ 1"))
    hand.change(spawn=["film"])
    hand.asker.ask(live.Attend(readings=("s0/IMG",)))
    show(hand, 10**15)
    assert [value.value for _, value in shown(hand)] == ["byte[120,160,3]"]
