"""The assembly that was written for the PUMA, done by others in its place: without forces, and by a SCARA (K03)."""

import pytest
from msgspec.structs import replace

from kit.labs.laboratory import Laboratory, job, joints, target
from kit.runtime.direct_client import OpenGate
from kit.worlds.box_cells import boxes_world
from onika.cli import main
from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.program import RuntimeProgram
from onika.host.units.virtual import VirtualDriver
from onika.laws import adept_one, reach
from onika.store.site import open_site
from onika.wire import event, request

pytestmark = pytest.mark.site

JOINT = "joint object"
WITHOUT_FORCES = {"puma": "puma_kin", "puma_right": "puma_right_kin"}
SIGNS = {"triangle": (0.70, 0.28), "square": (0.70, -0.28), "cross": (0.50, -0.18)}
WAVES, ABOVE, TABLE, HIGH = (0.70, 0.0), -0.125, -0.36, 0.0508
OPEN, CLOSE = "opengripC", "closegripC"


# ---- another robot in the plan of a program ----


def plan_of(name):
    planned = prepare_run(name, open_site([], {}, None))
    assert planned.faults == ()
    return planned


def task_of(path, name):
    """A shipped hardware task as it stands in a plan, and its code."""
    lab = Laboratory(path / name)
    lab.configuration("alone", f"{name} 500", "jtraj 250")
    plan = plan_of(str(lab.application("probe", [job("alone", "Joint job"), joints("there", *[0.0] * 6)]))).plan
    (task,) = (task for task in plan.flows[0].tasks if task.name == name)
    (code,) = (module for module in plan.code if module.digest == task.digest)
    return task, code


class Redirection:
    """The plan of an application with other hardware tasks in it, as those who redirect will make it."""

    def __init__(self, path, application, others):
        planned, self.loading = plan_of(application), ModuleFacts()
        self.found = prepare(planned.plan, planned.targets, self.loading)
        self.others = {old: task_of(path, new) for old, new in others.items()}
        self.lines, self.reasons = {}, []
        for number, flow in enumerate(planned.plan.flows):
            self._resolve(number, flow, planned.targets)
        flows = tuple(self._flow(number, flow) for number, flow in enumerate(planned.plan.flows))
        code = {module.digest: module for module in (*planned.plan.code, *(code for _, code in self.others.values()))}
        self.plan = replace(planned.plan, flows=flows, code=tuple(code.values()))
        self.targets = tuple(
            replace(aim, values=self.lines.get((aim.flow, aim.action), aim.values)) for aim in planned.targets
        )

    def _resolve(self, number, flow, targets):
        """Joint targets by way of their pose (law 26), for the robot of this flow."""
        aims = [aim for aim in targets if aim.flow == number and aim.kind == JOINT]
        theirs = self.found.constants[number]
        (new,) = (self.others[task.name] for task in flow.tasks if task.name in self.others)
        ours = self.loading.constants(new[1], new[0].local)
        for aim, posture in zip(aims, reach.transfer(theirs, ours, [aim.values for aim in aims]), strict=True):
            if isinstance(posture, str):
                self.reasons.append((flow.actions[aim.action].target, posture))
            else:
                self.lines[number, aim.action] = (*posture.tolist(), *aim.values[theirs["NDOF"] :])

    def _flow(self, number, flow):
        names = {old: new.name for old, (new, _) in self.others.items()}
        actions = tuple(
            replace(
                action,
                tasks=tuple(names.get(task, task) for task in action.tasks),
                rates=tuple((names.get(task, task), hz) for task, hz in action.rates),
                arguments=" ".join(map(repr, self.lines.get((number, index), ()))) or action.arguments,
            )
            for index, action in enumerate(flow.actions)
        )
        tasks = tuple(self.others[task.name][0] if task.name in self.others else task for task in flow.tasks)
        return replace(flow, tasks=tasks, actions=actions)


def told_of(plan, targets, seed=None):
    """Everything that is told of a run in virtual time, and its world."""
    server, preparation = OpenGate(), prepare(plan, targets, ModuleFacts())
    assert preparation.faults == []
    world = boxes_world(seed)
    driver = VirtualDriver(tuple(f"rt{k}" for k in range(2)), server.tell, worlds=lambda _name: world)
    program = RuntimeProgram(server, driver, ModuleFacts(), ("rt0", "rt1"))
    program.applications.take("me", preparation)
    program.applications.begin("me", request.Begin(watch=("LAMP",)))
    while program.advance(1_000_000_000):
        pass
    return server.events, world


def result_of(planned, **more):
    result = told_of(planned.plan, planned.targets, **more)[0][-1]
    assert isinstance(result, event.Result)
    return result


@pytest.mark.parametrize("robot", ["puma_kin", "scara", "scara_kin"])
def test_the_pumas_assembly_lights_the_lamp_with_another_robot(tmp_path, robot):  # R-K03, R-E09
    result = result_of(Redirection(tmp_path, "assemble", {"puma": robot}), seed=1)
    assert (result.completed, result.values["LAMP"]) == (True, 1)


def test_what_the_scara_cannot_do_is_named_before_anything_moves(tmp_path):  # R-E09, R-K03, law 26
    redirection = Redirection(tmp_path, "go_home", {"puma": "scara"})
    assert redirection.reasons == [
        ("home", "the hand would lean 180 degrees; this arm only holds it upright, fingers down")
    ]


def test_two_arms_without_forces_put_the_boxes_together(tmp_path):  # R-K02, R-K03
    result = result_of(Redirection(tmp_path, "assemble_together", WITHOUT_FORCES))
    assert (result.completed, result.values["LAMP"]) == (True, 1)


def test_one_arm_with_forces_and_one_without_are_refused(tmp_path):  # law 18
    redirection = Redirection(tmp_path, "two_arms", {"puma": "puma_kin", "puma_right": "puma_right"})
    (fault,) = prepare(redirection.plan, redirection.targets, ModuleFacts()).faults
    assert "all arms of a world are of one mode" in str(fault.reason)


def test_without_forces_equal_runs_are_equal_to_the_last_bit(tmp_path):  # R-X08, law 14
    redirection = Redirection(tmp_path, "go_home", {"puma": "puma_kin"})
    marks = [told_of(redirection.plan, redirection.targets)[1].fingerprint() for _ in range(2)]
    assert marks[0] == marks[1]


# ---- programs of its own ----


def line_to(sign, x, y, z):
    values = " ".join(map(str, (0, 0, -1, 0, 1, 0, x, y, z)))
    return [job("cmove_scaraC", "Cartesian job"), target(sign, "Cartesian object", values, "1.0")]


def hand(name):
    return [job(name)]


def carried(sign, level):
    """Fetch a box and put it on the stack, by straight lines alone."""
    place, stack = SIGNS[sign], TABLE + HIGH * (level + 0.5) + 0.0008
    return [
        *line_to("above", *place, ABOVE),
        *line_to("box", *place, TABLE + HIGH / 2),
        *hand(CLOSE),
        *line_to("above", *place, ABOVE),
        *line_to("over", *WAVES, ABOVE),
        *line_to("stack", *WAVES, stack),
        *hand(OPEN),
        *line_to("over", *WAVES, ABOVE),
    ]


@pytest.mark.parametrize(
    ("order", "lamp"),
    [(("triangle", "square", "cross"), 1), (("square", "triangle", "cross"), 0)],
    ids=["right", "wrong"],
)
def test_a_program_for_the_scara_lights_the_lamp_if_its_order_is_right(tmp_path, order, lamp):  # R-K01, R-K03
    steps = [step for level, sign in enumerate(order, 1) for step in carried(sign, level)]
    planned = plan_of(str(Laboratory(tmp_path).application("by_lines", [*hand(OPEN), *steps])))
    result = result_of(planned)
    assert (result.completed, result.values["LAMP"]) == (True, lamp)


def test_a_target_out_of_the_scaras_reach_is_named_before_the_run(capsys, tmp_path):  # R-E09, R-K03
    path = Laboratory(tmp_path).application("far", [*line_to("near", 0.6, 0.1, -0.2), *line_to("far", 0.9, 0.1, -0.2)])
    assert main(["run", str(path), "--virtual"]) == 2
    output = "".join(capsys.readouterr())
    assert "far: out of reach: the quill would be 0.906 m from joint 1's axis" in output
    assert "near:" not in output


def test_its_joints_are_moved_by_four_values(tmp_path):  # R-K03
    path = Laboratory(tmp_path).application("turn", [job("jmove_scaraC", "Joint job"), joints("there", *[0.0] * 6)])
    (flow,) = (plan := plan_of(str(path)).plan).flows
    goal = (0.1, 0.7, 0.1, -0.8)
    actions = tuple(replace(action, arguments=" ".join(map(str, (*goal, 1.0)))) for action in flow.actions)
    events, world = told_of(replace(plan, flows=(replace(flow, actions=actions),)), ())
    assert events[-1].completed
    assert world.state("scara_left")[2:] == pytest.approx(goal, abs=2e-3)
    assert abs(world.state("scara_left")[2] - adept_one.HOME[0]) > 1.0
