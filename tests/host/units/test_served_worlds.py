import pytest

from kit.worlds.mass_world import MassWorld
from onika.host.units.served_worlds import ServedWorlds
from onika.ring.device import DeviceOrder, DriveState
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.runtime.bus import SEGMENT_SIZE
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason

MS = 1_000_000
TAKES = {"key": "workcell.button_takes", "text": "1 pressed, 0 let go"}


class Yard(MassWorld):
    """A world that says what it was told, and until when it went at each step."""

    def __init__(self, name):
        super().__init__()
        self.name = name
        self.orders = []
        self.steps = []

    def fence(self, epoch):
        self.orders.append(("fence", epoch))
        super().fence(epoch)

    def stop(self):
        self.orders.append("stop")
        super().stop()

    def go_on(self):
        self.orders.append("go on")
        super().go_on()

    def step(self, until_ns):
        self.steps.append(until_ns)
        super().step(until_ns)


class Opened:
    """Worlds that were opened by name, and those that serve them."""

    def __init__(self):
        self.worlds = {}
        self.files = {}
        self.served = ServedWorlds(self._world)

    def _world(self, name, **files):
        self.files[name] = files
        if name == "sea":
            raise ValueError("expected a world on land, found 'sea'")
        return self.worlds.setdefault(name, Yard(name))

    def open(self, name="yard", now=0, **files):
        self.served.open(name, Segment.create(name, SEGMENT_SIZE), now, **files)
        return self.worlds[name]


@pytest.fixture
def opened():
    return Opened()


def test_a_world_whose_files_came_is_made_of_them(opened):  # R-X19
    files = WorldSource("field", "abc", ())
    opened.open("yard")
    opened.open("field", files=files)
    assert opened.files == {"yard": {}, "field": {"files": files}}


def test_a_world_is_opened_by_its_name_and_an_unknown_one_refused(opened):  # law 16
    assert (opened.served.names, opened.served.due_ns()) == ((), None)
    with pytest.raises(ValueError, match="found 'sea'"):
        opened.open("sea")
    opened.open("yard")
    opened.open("field")
    assert opened.served.names == ("yard", "field")


def test_a_world_says_at_its_opening_whether_it_is_simulated(opened):  # R-E09
    opened.worlds["model"] = Yard("model")
    opened.worlds["model"].is_simulated = True
    kinds = [opened.served.open(name, Segment.create(name, SEGMENT_SIZE), 0) for name in ("model", "yard")]
    assert kinds == [True, False]


def test_what_is_done_with_a_device_of_one_world_does_nothing_to_its_namesake_in_another(opened):  # R-E09, law 18
    yard, field = opened.open("yard"), opened.open("field")
    opened.served.grant("yard:m0", 4)
    opened.served.grant("field:m0", 5)
    opened.served.step("yard", 20 * MS)
    yard.command("m0", 4, DeviceOrder.DRIVE, [1.0])
    opened.served.step("yard", 30 * MS)
    opened.served.step("field", 30 * MS)
    assert opened.served.modes()["yard:m0"] is not DriveMode.HELD
    assert opened.served.modes()["field:m0"] is DriveMode.HELD
    assert (yard.state("m0")[2] > 0.0, field.state("m0")[2]) == (True, 0.0)
    opened.served.fence(5)
    opened.served.release("field:m0", 5)
    opened.served.touch("field", "panic", 1.0)
    assert yard.orders == [("fence", 5)]
    assert opened.served.modes()["yard:m0"] is not DriveMode.HELD


def test_a_stop_stops_every_world_that_is_open_and_those_that_are_opened_later(opened):  # law 27, R-X24
    yard, field = opened.open("yard"), opened.open("field")
    opened.served.stop()
    shed = opened.open("shed")
    assert [world.orders for world in (yard, field, shed)] == [["stop"]] * 3
    assert set(opened.served.modes().values()) == {DriveMode.STOPPED}


def test_only_the_permission_to_move_ends_a_stop(opened):  # law 27, R-X24
    yard = opened.open("yard")
    opened.served.stop()
    opened.served.fence(3)
    field = opened.open("field")
    assert field.orders == ["stop"], "a dead writer ends no stop"
    opened.served.go_on()
    shed = opened.open("shed")
    assert [world.orders for world in (yard, field, shed)] == [["stop", ("fence", 3), "go on"], ["stop", "go on"], []]


def test_a_dead_writer_is_fenced_in_every_world(opened):  # law 17
    yard, field = opened.open("yard"), opened.open("field")
    opened.served.grant("field:m1", 7)
    opened.served.fence(7)
    assert (yard.orders, field.orders) == ([("fence", 7)], [("fence", 7)])
    assert opened.served.modes() == {
        "yard:m0": DriveMode.HELD,
        "yard:m1": DriveMode.HELD,
        "field:m0": DriveMode.HELD,
        "field:m1": DriveMode.TRIPPED,
    }


def test_a_device_is_claimed_by_one_writer_until_it_is_released(opened):  # law 18
    opened.open()
    grant = opened.served.grant("yard:m0", 4)
    assert (grant.segment, grant.name, grant.epoch) == ("bus:yard", "m0", 4)
    with pytest.raises(ValueError, match="claimed already"):
        opened.served.grant("yard:m0", 5)
    opened.served.release("yard:m0", 5)
    with pytest.raises(ValueError, match="claimed already"):
        opened.served.grant("yard:m0", 5)
    opened.served.release("yard:m0", 4)
    assert opened.served.grant("yard:m0", 5).epoch == 5


def test_a_world_steps_with_the_runtime_from_when_it_was_opened(opened):  # law 16
    yard = opened.open(now=20 * MS)
    assert (opened.served.behind_ns("yard"), opened.served.due_ns()) == (20 * MS, 21 * MS)
    opened.served.step("yard", 21 * MS - 1)
    assert yard.steps == []
    opened.served.step("yard", 21 * MS)
    assert yard.steps == [1 * MS]
    assert opened.served.due_ns() == 22 * MS
    opened.served.step("yard", 24 * MS)
    assert (yard.steps, yard.now_ns) == ([1 * MS, 4 * MS], 4 * MS)


def test_a_world_that_has_run_already_goes_on_from_its_own_time(opened):  # law 16
    opened.worlds["yard"] = Yard("yard")
    opened.worlds["yard"].step(5 * MS)
    opened.open(now=20 * MS)
    assert (opened.served.behind_ns("yard"), opened.served.due_ns()) == (15 * MS, 21 * MS)


def test_the_world_that_has_to_step_first_says_when(opened):  # law 16
    opened.open("late", now=8 * MS)
    opened.open("early", now=3 * MS)
    assert opened.served.due_ns() == 4 * MS


def test_a_world_that_is_late_runs_after_the_time_by_50_ms_at_most(opened):  # law 13
    yard = opened.open()
    opened.served.step("yard", 50 * MS)
    assert (yard.now_ns, opened.served.behind_ns("yard")) == (50 * MS, 0)
    opened.served.step("yard", 100 * MS + 1)
    assert (yard.now_ns, opened.served.behind_ns("yard")) == (51 * MS, 49 * MS + 1)
    opened.served.step("yard", 102 * MS)
    assert yard.now_ns == 52 * MS, "what was lost is not made up for"
    opened.served.step("yard", 1000 * MS)
    assert (yard.now_ns, opened.served.behind_ns("yard")) == (53 * MS, 947 * MS)


def test_what_drives_do_is_told_by_the_step_after_it(opened):  # R-X06
    yard = opened.open()
    grant = opened.served.grant("yard:m0", 1)
    yard.command("m0", grant.epoch, DeviceOrder.DRIVE, [1.0])
    assert [(event.device, event.state) for event in opened.served.step("yard", MS)] == [("m0", DriveState.DRIVEN)]
    assert list(opened.served.step("yard", 2 * MS)) == []
    opened.served.stop()
    told = opened.served.step("yard", 2 * MS)
    assert [(event.device, event.state) for event in told] == [("m0", DriveState.HELD)], "also between two steps"


def test_a_hand_touches_the_part_of_the_world_that_is_named(opened):  # R-K06
    opened.open("yard")
    opened.open("field")
    opened.served.touch("field", "panic", 1.0)
    modes = opened.served.modes()
    assert (modes["yard:m0"], modes["field:m0"]) == (DriveMode.HELD, DriveMode.PRESSED)
    with pytest.raises(ValueError, match="bell"):
        opened.served.touch("yard", "bell", 1.0)


def test_worlds_show_what_they_are_and_where(opened):  # R-K06
    yard = opened.open()
    opened.served.step("yard", 3 * MS)
    assert opened.served.scene("field") is None
    assert opened.served.scene("yard") == {"shapes": [], "parts": {"panic": TAKES}}
    assert opened.served.poses("yard") == (3 * MS, yard.poses().tobytes(), ())
    assert opened.served.snapshots() == {"yard": yard.snapshot()}


class Stage(Yard):
    """A world that is put back, and says so; it knows nothing of its places."""

    is_simulated = True

    def reset(self):
        self.orders.append("reset")

    def places(self):
        return ()

    def displaced(self):
        return (Displacement(Reason.plain(f"{self.name} is not as it was")),) if "reset" not in self.orders else ()


def test_the_world_that_is_named_is_put_back_and_a_stop_stays(opened):  # laws 18, 27
    for name in ("stage", "other"):
        opened.worlds[name] = Stage(name)
        opened.open(name)
    assert opened.served.displaced() == {
        "stage": (Displacement(Reason.plain("stage is not as it was")),),
        "other": (Displacement(Reason.plain("other is not as it was")),),
    }
    opened.served.put_back("stage")
    assert (opened.worlds["stage"].orders, opened.worlds["other"].orders) == (["reset"], [])
    assert opened.served.displaced() == {"stage": (), "other": (Displacement(Reason.plain("other is not as it was")),)}
    opened.served.stop()
    opened.served.put_back("other")
    assert opened.worlds["other"].orders == ["stop", "reset", "stop"]


def test_a_world_that_nobody_can_put_back_is_refused(opened):  # law 18
    opened.open("yard")
    with pytest.raises(ValueError, match="by hand"):
        opened.served.put_back("yard")


class Teller(Yard):
    """A world that says how it stands."""

    sentences = ()

    def standing(self):
        return list(self.sentences)


def test_how_worlds_stand_is_told_of_those_that_know_how(opened):  # R-E16
    lamp, door = Reason.plain("the lamp is lit"), Reason.plain("the door is shut")
    opened.worlds.update(yard=Teller("yard"), mute=Teller("mute"))
    opened.worlds["yard"].sentences = (lamp, door)
    assert opened.served.standings() == {}
    for name in ("plain", "yard", "mute"):
        opened.open(name)
    assert opened.served.standings() == {"yard": (lamp, door)}
    opened.worlds["yard"].sentences = (door,)
    assert opened.served.standings() == {"yard": (door,)}, "as it stands now"
