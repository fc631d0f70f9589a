"""One executor under two clients: news is noted, told, and handed on in this order; a client's orders go to units."""

import pytest

from kit.plans.plan_builder import action
from kit.runtime.executor import executor
from kit.worlds.rail_world import YardLoading, rail_tasks
from onika.engine import orders
from onika.host.loading.plan_preparation import prepare
from onika.model.lifecycle import State
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.runtime.user_input import AskedItem
from onika.wire import event
from onika.words.reason import NOTHING, Reason

ITEM = AskedItem("goal", "double", 1, "m", "where to", None, None, None)
MS = 1_000_000


class Scene:
    """A mass and its servo, a client that notes what it hears, and units that note what they are told."""

    def __init__(self):
        self.story, self.sent, self.released, self.lost = [], [], [], {}
        self.prepared = prepare(rail_tasks().plan([action("mass", "servo", arguments="1")]), (), YardLoading())
        homes = {"mass": "rt0", "servo": "rt1"}
        table = Table(Segment.create("table", SIZE))
        subsystem = RunningSubsystem("flow0", table, self.prepared.flows[0], homes, {"SIDES": 2})
        self.executor = executor(subsystem, self, self.follow, self.story.append, self.lost)
        for code in self.prepared.code.values():
            self.executor.spawner.add_code(code)

    def follow(self, message, before):
        self.story.append((type(message).__name__, message.task, before.value, self.executor.state(message.task).value))

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))

    def grant(self, rtpu, device):
        return command.DeviceGrant("bus:yard", device, ("x",), ("f",), {}, 1, 0, 64)

    def release(self, device):
        self.released.append(device)

    def take(self, kind):
        taken = [(rtpu, order) for rtpu, order in self.sent if isinstance(order, kind)]
        self.sent = [order for order in self.sent if order not in taken]
        return taken

    def hear(self, message):
        self.executor.hear(message, 9 * MS)

    def born(self):
        for task in ("servo", "mass"):
            self.executor.expect(task)
        self.executor.spawn_ready()
        self.executor.subsystem.table.ring("SIDES").write((2).to_bytes(4, "little"))
        for task in ("mass", "servo"):
            self.hear(news.Initialised("flow0", task))
        self.story.clear()
        return self


@pytest.fixture
def scene():
    return Scene()


def spawned(scene):
    return [(rtpu, order.task) for rtpu, order in scene.take(command.Spawn)]


def test_whoever_needs_a_constant_is_spawned_after_its_supplier(scene):  # law 10
    for task in ("servo", "mass", "servo"):
        scene.executor.expect(task)
    scene.executor.spawn_ready()
    assert spawned(scene) == [("rt0", "mass")]
    scene.executor.subsystem.table.ring("SIDES").write((2).to_bytes(4, "little"))
    scene.hear(news.Initialised("flow0", "mass"))
    assert spawned(scene) == [("rt1", "servo")]
    scene.executor.spawn_ready()
    assert spawned(scene) == []


def test_who_is_not_wanted_any_more_is_not_spawned(scene):  # R-E14
    scene.executor.expect("mass")
    assert not scene.executor.kill("mass")
    scene.executor.spawn_ready()
    assert scene.sent == []


def test_a_spawn_that_cannot_be_is_heard_by_the_client_as_a_refusal(scene):  # R-E10
    scene.lost["rt0"] = "rt0 was killed"
    scene.executor.expect("mass")
    scene.executor.spawn_ready()
    assert scene.story == [("Refused", "mass", "WAITING", "WAITING")]
    assert not scene.executor.is_alive("mass")


def test_a_spawn_that_the_unit_refuses_gives_the_device_back(scene):  # law 18
    scene.executor.expect("mass")
    scene.executor.spawn_ready()
    scene.hear(news.Refused("flow0", "mass", "spawn", Reason.plain("this unit was stopped")))
    assert scene.released == ["yard:m0"]
    assert not scene.executor.is_alive("mass")


def test_the_state_is_noted_then_told_then_heard_by_the_client(scene):
    scene.born().hear(news.Changed("flow0", "servo", "ON", 5 * MS))
    assert scene.story == [
        event.TaskState("flow0", "servo", "ON", 0.005),
        ("Changed", "servo", "OFF", "ON"),
    ]


def test_seconds_count_from_the_beginning(scene):
    scene.born().executor.begin(4 * MS)
    scene.hear(news.Changed("flow0", "servo", "ON", 5 * MS))
    assert scene.story[0].at_s == 0.001


def test_what_a_task_asks_is_a_question_until_it_is_answered(scene):  # R-A10
    scene.born().hear(news.Asked("flow0", "servo", NOTHING, (ITEM,), 5 * MS))
    assert scene.executor.open_questions
    assert scene.executor.questions == ()  # the client may have the answer
    scene.executor.ask_user(news.Asked("flow0", "servo", NOTHING, (ITEM,), 5 * MS))
    assert [question.task for question in scene.executor.questions] == ["servo"]
    assert scene.story[-1] == scene.executor.questions[0]
    scene.hear(news.Changed("flow0", "servo", "ON", 6 * MS))
    assert (bool(scene.executor.open_questions), scene.executor.questions) == (False, ())


def switch(*on, off=()):
    return orders.Switch(0, off, tuple(orders.Launch(task) for task in on))


def test_after_a_failure_the_client_decides_before_the_rest_of_the_switch_goes_out(scene):  # law 3, R-E08
    scene.born().executor.switch(switch("mass", "servo"))
    assert [rtpu for rtpu, _ in scene.take(command.Switch)] == ["rt0"]
    scene.executor._client = lambda _message, _before: scene.executor.drop_switches()
    scene.hear(news.Failed("flow0", "mass", "on", Reason.plain("no"), "", 0, "", 5 * MS))
    assert scene.take(command.Switch) == []


@pytest.mark.parametrize("entry", ["on", "rank"])
def test_only_a_refusal_of_the_launch_lets_the_rest_of_the_switch_go_on(scene, entry):  # law 3
    scene.born().executor.switch(switch("mass", "servo"))
    scene.take(command.Switch)
    scene.hear(news.Refused("flow0", "mass", entry, Reason.plain("no")))
    assert [rtpu for rtpu, _ in scene.take(command.Switch)] == (["rt1"] if entry == "on" else [])


def test_the_tasks_of_a_lost_unit_are_gone_and_their_last_words_are_not_heard(scene):  # R-E10
    scene.born()
    scene.lost["rt0"] = "rt0 was killed"
    scene.executor.lost("rt0", 7 * MS)
    assert scene.story == [event.TaskState("flow0", "mass", "KILLED", 0.007), ("Changed", "mass", "OFF", "KILLED")]
    assert scene.released == ["yard:m0"]
    scene.hear(news.Changed("flow0", "mass", "ON", 8 * MS))
    assert scene.executor.state("mass") is State.KILLED


def test_words_of_strangers_change_nothing(scene):
    scene.born().hear(news.Changed("flow0", "nobody", "ON", 5 * MS))
    assert scene.story == []
    assert scene.executor.state("nobody") is State.KILLED


def test_who_stays_keeps_its_state_and_learns_its_new_rank(scene):  # law 1
    scene.born().hear(news.Changed("flow0", "servo", "ON", 5 * MS))
    placements = [(member.wired, member.rtpu) for member in scene.executor.members.values()]
    scene.executor.rewire([(wired, rtpu) for wired, rtpu in placements if wired.name == "servo"], {})
    assert list(scene.executor.members) == ["servo"]
    assert scene.executor.state("servo") is State.ON
    ranks = [order.ranks for _, order in scene.take(command.Rank)]
    assert ranks in ([], [(("servo", 0),)])


# A writer fails


def failed(entry="cycle"):
    return news.Failed("flow0", "servo", entry, Reason.plain("ill"), "", 0, "", 5 * MS)


def working(scene):
    scene.born()
    for task in ("mass", "servo"):
        scene.hear(news.Changed("flow0", task, "ON", 4 * MS))
    scene.sent.clear()
    return scene


def test_hardware_on_another_unit_is_starved_when_its_writer_fails(scene):  # law 4
    working(scene).hear(failed())
    ((rtpu, order),) = scene.take(command.Starve)
    assert (rtpu, order.subsystem, order.task) == ("rt0", "flow0", "mass")
    assert str(order.cause) == "task servo, which wrote FORCE, is ERROR: the device is not driven on with that"


def test_so_it_is_when_the_unit_of_its_writer_is_gone(scene):  # laws 4, 30
    working(scene).lost["rt1"] = Reason.plain("rt1 was killed")
    scene.executor.lost("rt1", 6 * MS)
    ((rtpu, order),) = scene.take(command.Starve)
    assert (rtpu, order.task) == ("rt0", "mass")
    assert "task servo, which wrote FORCE, is KILLED" in str(order.cause)


def test_hardware_that_is_gone_with_its_writer_is_told_nothing(scene):  # law 30
    working(scene).lost.update(rt0=Reason.plain("rt0 was killed"), rt1=Reason.plain("rt1 was killed"))
    scene.executor.lost("rt1", 6 * MS)
    assert scene.sent == []


def test_who_fails_as_it_goes_off_starves_nobody(scene):  # law 6
    working(scene).hear(failed("off"))
    assert scene.take(command.Starve) == []


def test_who_fails_before_it_is_on_starves_nobody(scene):  # law 22
    working(scene).hear(news.Changed("flow0", "servo", "OFF", 5 * MS))
    scene.hear(failed("on"))
    assert scene.take(command.Starve) == []
