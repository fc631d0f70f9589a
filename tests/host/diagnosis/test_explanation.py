import struct

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.worlds.rail_world import YardLoading
from onika.host.diagnosis import explanation
from onika.host.diagnosis.explanation import explain
from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.host.diagnosis.variable_history import VariableHistory
from onika.host.loading.plan_preparation import prepare
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.wire.event import decode, encode
from onika.wire.steer import Position
from onika.words.reason import Reason
from onika.words.shape import Shape

MS = 1_000_000
HEAD = "from onika.module import InConst, InVar, Module, OutConst, OutVar\n"


def module(name, trigger=False, **ports):
    """The text of a module; ports are written `NAME="InVar double rad"`."""
    lines = [HEAD, f"class {name.capitalize()}(Module):", f"    trigger = {trigger}"]
    for port, text in ports.items():
        kind, shape, unit = text.split()
        lines.append(f"    {port} = {kind}({shape!r}, {unit!r}, 'one')")
    return "\n".join(lines) + "\n"


class Scene:
    """One flow of one action: `goal` feeds `law`, `law` feeds `arm`; `aside` is not part of the action."""

    def __init__(self):
        shop = PlanBuilder()
        shop.task("goal", module("goal", True, LIMIT="OutConst double rad", Q_GOAL="OutVar double rad"))
        shop.task("law", module("law", Q_GOAL="InVar double rad", BIG="InVar double[60] m", TAU="OutVar double N.m"))
        shop.task("arm", module("arm", LIMIT="InConst double rad", TAU="InVar double N.m", Q="OutVar double rad"))
        shop.task("aside", module("aside", Q="InVar double rad", TAU_2="OutVar double N.m"))
        plan = shop.plan([action("goal", "law", "arm")], [action("goal", "law", "arm", "aside")])
        self.prepared = prepare(plan, (), YardLoading())
        self.table = Table(Segment.create("explanation", 1 << 18))
        self.history = VariableHistory({"flow0": self.table})

    def write(self, **values):
        for name, value in values.items():
            numbers = value if isinstance(value, list) else [value]
            self.table.entry(name, Shape.parse(f"double[{len(numbers)}]" if isinstance(value, list) else "double"))
            self.table.ring(name).write(struct.pack(f"={len(numbers)}d", *numbers))
        return self

    def lives(self, looks=1):
        for look in range(looks):
            self.history.look(look * 50 * MS)
        return self

    def explanation(self, **changes):
        fields = {"kind": CauseKind.ERROR, "text": Reason.plain("no"), "subsystem": "flow0", "task": "arm"} | changes
        places = [Position("flow0", "stopped", 0, failed=("arm",)), Position("flow1", "running", 0)]
        return explain(self.prepared, Cause(**fields), places, self.history, 1.5)

    def shown(self, **changes):
        return [course.variable for course in self.explanation(**changes).courses]


@pytest.fixture
def scene():
    return Scene().write(Q_GOAL=1.0, TAU=2.0, Q=3.0, TAU_2=4.0, LIMIT=2.0).lives()


def test_a_tasks_own_variables_come_first_then_what_feeds_it(scene):  # R-X06
    assert scene.shown() == ["TAU", "Q", "Q_GOAL"]
    assert [course.unit for course in scene.explanation().courses] == ["N.m", "rad", "rad"]


@pytest.mark.parametrize("changes", [{"entry": "init"}, {"kind": CauseKind.ASKING}])
def test_constants_matter_where_they_are_read(scene, changes):  # R-X06
    assert scene.shown(**changes)[0] == "LIMIT"


def test_the_way_of_what_is_no_number_is_shown_before_all_else():  # R-X06, law 5
    scene = Scene().write(Q_GOAL=float("nan"), TAU=float("nan"), Q=3.0).lives()
    assert scene.shown() == ["TAU", "Q_GOAL", "Q"]
    assert scene.explanation().suspect == "goal"


def test_only_an_error_raises_a_suspicion():  # R-X06
    scene = Scene().write(TAU=float("nan")).lives()
    assert scene.explanation(kind=CauseKind.PRESSED).suspect == ""


def test_of_what_was_never_written_nothing_is_said():  # R-X06
    assert Scene().write(TAU=1.0).lives().shown() == ["TAU"]
    assert Scene().lives().shown() == []


def test_a_cause_without_a_task_shows_no_variables(scene):  # R-X06
    diagnosis = scene.explanation(kind=CauseKind.USER, subsystem="", task="", text=Reason.plain("enough"))
    assert (diagnosis.courses, diagnosis.waiting, diagnosis.action, diagnosis.index, diagnosis.place) == (
        (),
        (),
        "",
        -1,
        "",
    )


def test_before_the_first_action_the_tasks_own_file_is_the_place(scene):  # R-X06
    cause = Cause(CauseKind.REFUSED, Reason.plain("spawn: no"), "flow0", "arm")
    diagnosis = explain(scene.prepared, cause, [Position("flow0", "spawning", -1)], scene.history, 0.0)
    assert (diagnosis.place, diagnosis.action, diagnosis.index) == ("arm.rmod", "", -1)


def test_an_explanation_is_bounded_however_much_there_is(monkeypatch):  # R-X06
    scene = Scene().write(Q_GOAL=1.0, TAU=2.0, Q=3.0, BIG=[1.0] * 60).lives(100)
    assert scene.shown() == ["TAU", "Q", "Q_GOAL", "BIG"]
    assert len(encode(scene.explanation())) < 1 << 16
    monkeypatch.setattr(explanation, "MOST_NUMBERS", 3 * 61)
    assert scene.shown() == ["TAU", "Q", "Q_GOAL"]
    monkeypatch.setattr(explanation, "MOST_COURSES", 2)
    assert scene.shown() == ["TAU", "Q"]


def test_it_travels(scene):
    diagnosis = scene.explanation(path="arm.py", line=7)
    assert decode(encode(diagnosis)) == diagnosis
