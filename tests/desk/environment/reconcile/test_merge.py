import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.desk.environment.reconcile.merge import runtime_view, seen, task_of
from onika.desk.plan.compile import planned_task
from onika.model.task import LocalLine, Task
from onika.wire import act, live, request, view
from onika.wire.runtime_standing import RtpuStanding, Standing, SubsystemStanding
from onika.words.reason import NOTHING, Reason

TASKS = (
    *(Task(name, name, outvar=(name.upper(),), frequency=10.0) for name in ("a", "b")),
    Task("rival", "rival", outvar=("A",), frequency=10.0),
)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def test_a_living_task_is_what_its_file_said():
    task = Task("a", "m", aliases=(("X", "Y"),), inconst=("N",), invar=("X",), frequency=5.0,
                local=(LocalLine("GAIN", ("2",)),))  # fmt: skip
    assert task_of(planned_task(task, "rt0", "0", "a.rmod")) == task


def test_the_runtime_is_shown_as_it_stands():
    homes = (SubsystemStanding("left", "anna#2", "", ()), SubsystemStanding("right", "", "assemble", ()))
    units = (RtpuStanding("rt0", False, 0.123), RtpuStanding("rt1", True, 0.0))
    shown = runtime_view(
        view.RuntimeView(address="ws://x", stop_text=Reason.plain("why"), world_kinds={"sea": "real", "boxes": "real"}),
        Standing(homes, units, ("boxes", "cell"), True, True, 1.0, simulated=("boxes",), libraries=("https://x/arm",)),
    )
    assert shown == view.RuntimeView(
        "linked", "ws://x", NOTHING, True, True, Reason.plain("why"),
        {"rt0": view.UnitView(0.12), "rt1": view.UnitView(0.0, True)}, {"boxes": True, "cell": True},
        subsystems={"left": "anna#2", "right": "assemble"},
        holds={"left": view.HoldView("anna#2"), "right": view.HoldView("", "assemble")},
        inside={"right": view.SubsystemView("assemble")},
        world_kinds={"sea": "real", "boxes": "simulated", "cell": "real"},
        libraries=("https://x/arm",),
    )  # fmt: skip


def test_of_the_libraries_that_a_runtime_names_no_more_is_shown_than_can_be_read():  # R-C19
    many = ("", "x" * 501, "a", "a", *map(str, range(50)))
    shown = runtime_view(view.RuntimeView(), Standing((), (), (), True, False, 1.0, libraries=many))
    assert shown.libraries == ("a", *map(str, range(19)))


def test_what_somebody_else_brings_to_life_comes_onto_the_canvas(duet):  # R-C12
    doc = duet.connected("a")
    planned = duet.edits()[-1].spawn[0]
    import msgspec

    other = msgspec.structs.replace(planned, name="b", module="b")
    duet.runtime.ask(live.Change("Untitled-1", spawn=(other,), on=(live.Turn("b"),)))
    duet.hear()
    duet.pump()
    assert duet.state(doc, "b") == "ON" and duet.document(doc).content.wanted == {"a": False, "b": True}
    assert str(duet.document(doc).history.last.label) == "placing a"  # a fact is no step


def test_nothing_comes_of_a_survey_that_is_refused_or_too_late(duet):
    doc = duet.connected("a")
    model = duet.environment.model
    assert seen(model, request.Refused(Reason.plain("gone")), doc).model is model
    standing = duet.runtime.ask(live.Survey())
    assert seen(model, standing, "c9").model.documents == model.documents
    duet.do(act.Disconnect(doc))
    left = duet.environment.model
    assert seen(left, standing, doc).model.documents == left.documents


def test_a_task_that_leaves_for_one_that_runs_leaves_its_supermodule(duet):  # R-C12, R-C17
    doc = duet.connected("rival")
    duet.do(act.Disconnect(doc))
    doc = duet.new("a", "b")
    duet.do(act.Group(doc, "arm", ("b", "a")))
    duet.do(act.Connect(doc))
    shown = duet.environment.tree.documents[doc]
    assert set(shown.tasks) == {"b", "rival"} and shown.groups["arm"].tasks == ("b",)
