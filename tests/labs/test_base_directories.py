"""The shipped laboratories as data: every file reads without fault, and the jobs and applications fit together."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from kit.worlds.box_cells import base_of
from onika.files import syntax as syntax_file
from onika.laws import puma560
from onika.laws.frames import pose_of_nine
from onika.laws.inverse import serial_inverse
from onika.laws.path import PEAK, joint_duration
from onika.laws.textbook import serial_arm
from onika.model import pad
from onika.model.application import Icon, actions, every_flow
from onika.model.port import PortKind
from onika.model.rules.jigsaw import misfits
from onika.store.shipped import shipped, shipped_directories
from onika.store.site import open_site
from onika.words.value import ValueType

SITE = open_site((), {}, None)
SYNTAX = SITE.syntax()[0]
SPEED = 0.6 * puma560.QDMAX  # LOCAL SPEED of jtraj
TRIGGERS = {
    *("carc", "button", "jdrive", "jjog", "jpath", "jplay", "jpoly", "jramp", "jruckig", "teach", "track"),
    *("choose", "counter", "sorter", "when"),
    *("expert_chooses", "expert_judges", "expert_learns", "expert_reports"),
    "jtraj",
    "jvia",
    "ctraj",
    "cshift",
    "cguard",
    "press",
    "opengrip",
    "closegrip",
    "repeat",
    "pause",
    "holds",
    "wider",
    "lamp_lit",
    "calibration",
    "open_folder",
    "only_files",
    "copy_files",
    "list_files",
    "squeeze",
    "ibvs",
    "topoint",
    "pursue",
    "gopose",
    "preshape",
    "csense",
    "cfollow",
    "fingers",
    "gohome",
    "planner",
}
MOVES = ("jmove", "cmove", "visit")
OTHERS = ("gantry", "hill", "plate", "fingers", "modular", "motor")
"""In the names of jobs of what is no PUMA."""
BEGINS_ELSEWHERE = {"put_back", "visit"}
"""Applications that are nested in others, and begin where those have gone."""
APPLICATION_TESTS = Path(__file__).parents[1] / "site" / "applications"
COUNTS = {
    PortKind.INCONST: "inconst",
    PortKind.OUTCONST: "outconst",
    PortKind.INVAR: "invar",
    PortKind.OUTVAR: "outvar",
}


def names(folder, ending):
    return sorted(path.stem for base in shipped_directories() for path in (base / folder).glob(f"*{ending}"))


@cache  # of a hundred tests each reads the same files
def read(kind, name, *more):
    opened, faults = getattr(SITE, kind)(name, *more)
    assert faults == ()
    return opened


def tasks_of(configuration):
    placed = read("configuration", configuration).placed
    return {task.task: task.of(read("task", task.file).task) for task in placed}


def test_every_module_stands_in_a_shipped_job():  # R-K05
    jobs = [task.module for name in names("conf", ".conf") for task in tasks_of(name).values()]
    assert set(names("module", ".py")) - set(jobs) == set()


def test_every_job_is_carried_out_by_an_application_or_by_a_test_that_names_it():  # R-K05
    carried_out = {icon.onikon.name for name in names("appl", ".appl") for icon in icons_of(name)}
    alone = [name for name in names("conf", ".conf") if name not in carried_out]
    tests = "".join(path.read_text("utf-8") for path in APPLICATION_TESTS.glob("*.py"))
    spelt = {name: {name, name.replace("_right", "{arm}")} for name in alone}
    assert [name for name in alone if not any(word in tests for word in spelt[name])] == []


def test_the_syntax_defines_the_shipped_target_types():  # R-B10, R-D02
    assert SITE.syntax()[1] == ()
    targets = {kind.name: [(i.name, i.type, i.count) for i in kind.items] for kind in SYNTAX.types if kind.is_target}
    double = ValueType.DOUBLE
    assert targets["Joint object"] == [("endpoint", double, 6), ("duration", double, 1)]
    assert targets["Cartesian object"] == [("pose", double, 9), ("duration", double, 1)]
    assert targets["Relative object"] == [("shift", double, 3), ("duration", double, 1)]
    assert [name for name, _, _ in targets["Guarded object"]] == ["pose", "duration", "force", "torque"]
    whole = ValueType.INT
    assert targets["Single joint object"] == [("joint", whole, 1), ("angle", double, 1), ("duration", double, 1)]
    assert set(targets) == {
        *("Joint object", "Cartesian object", "Polynomial path object", "Force object", "Pause object"),
        *("File name object", "Index object", "Picture point object", "Number object", "Level object"),
        *("Relative object", "Guarded object", "Single joint object", "Single polynomial object"),
        *("Signal level object", "Folder object", "Choice object", "Gripper object", "Place object"),
        "Goal object",
    }
    for target in targets:
        for action in ("job", "application"):
            assert SYNTAX.target_type_of(target.replace("object", action)) == target


def test_edges_differ_by_shape_and_by_colour():  # R-X11
    speaking = [edge for edge in SYNTAX.edges if edge.number > 1]
    assert len({edge.vertices for edge in SYNTAX.edges}) == len(SYNTAX.edges)
    assert len({edge.rgb for edge in speaking}) == len(speaking) == 20
    for edge in SYNTAX.edges[1:]:
        assert np.sum(edge.vertices, axis=0).tolist() == [0, 32], "an edge ends below where it began"


def test_every_target_type_has_an_edge_of_its_own():  # R-D03: targets follow their own jobs only
    edges = [kind.left_edge for kind in SYNTAX.types if kind.is_target]
    assert len(set(edges)) == len(edges)
    for kind in SYNTAX.types:
        if kind.needs_target:
            assert kind.right_edge == SYNTAX.find(SYNTAX.target_type_of(kind.name)).left_edge


def test_the_syntax_file_is_written_as_it_was_read():  # R-B08
    text = (shipped() / "prefs" / syntax_file.NAME).read_text()
    assert syntax_file.write(SYNTAX) == text


def test_the_start_and_stop_pictures_can_be_read():  # R-B05
    pictures, faults = SITE.flow_pictures()
    assert faults == ()
    assert pictures[0] != pictures[1]


def test_no_name_is_given_twice():  # R-C01, R-D15
    assert SITE.duplicates() == ()


@pytest.mark.parametrize("name", names("conf", ".conf"))
def test_a_configuration_begins_with_its_hardware_and_ends_with_its_trigger(name):
    tasks = list(tasks_of(name).values())
    has_device = [any(line.key == "DEVICE" for line in task.local) for task in tasks]
    assert has_device[0] or not any(has_device)
    assert [task.module for task in tasks if task.module in TRIGGERS] == [tasks[-1].module]


@pytest.mark.parametrize("name", names("conf", ".conf"))
def test_no_input_hangs_and_no_output_is_shared(name):  # R-C07, R-C08 (Equations 2, 3, 6)
    tasks = tasks_of(name).values()
    outputs = [svar for task in tasks for svar in task.outputs]
    assert len(set(outputs)) == len(outputs)
    assert set().union(*(task.inputs for task in tasks)) <= {*outputs, pad.NAME}


@pytest.mark.parametrize("name", names("conf", ".conf"))
def test_every_variable_has_one_locus_with_the_right_counts(name):  # R-B02, R-C09
    loci = {locus.svar: locus for locus in read("configuration", name).loci}
    expected = {}
    for task in tasks_of(name).values():
        kinds = task.kinds()
        for coded, svar in zip(kinds, task.svars(tuple(kinds)), strict=True):
            row = expected.setdefault(svar, {"conns": set()} | dict.fromkeys(COUNTS.values(), 0))
            row["conns"].add(task.name)
            row[COUNTS[kinds[coded]]] += 1
    refusals = {
        svar: {"conns": locus.conns} | {count: getattr(locus, count) for count in COUNTS.values()}
        for svar, locus in loci.items()
    }
    assert refusals == {svar: row | {"conns": len(row["conns"])} for svar, row in expected.items()}


@pytest.mark.parametrize("name", names("conf", ".conf"))
def test_tasks_do_not_lie_on_each_other_and_loci_lie_beside_them(name):  # R-C24
    configuration, tasks = read("configuration", name), tasks_of(name)
    boxes = []
    for placed in configuration.placed:
        task = tasks[placed.task]
        rows = max(len(task.inconst + task.invar), len(task.outconst + task.outvar), 1)
        boxes.append((placed.x, placed.y, placed.x + 136, placed.y + 68 + 18 * rows))
    for k, (left, top, right, bottom) in enumerate(boxes):
        for other in boxes[k + 1 :]:
            assert right <= other[0] or other[2] <= left or bottom <= other[1] or other[3] <= top
        for locus in configuration.loci:
            assert not (left < locus.x + 5 < right and top < locus.y + 5 < bottom), locus.svar


@pytest.mark.parametrize("name", names("conf", ".conf"))
def test_every_configuration_has_its_icon_of_the_type_of_its_trigger(name):  # R-C16
    trigger = list(tasks_of(name).values())[-1]
    assert read("onikon", name, SYNTAX).type == (trigger.object_type or "Complete job")


@pytest.mark.parametrize("name", names("dict", ".onk"))
def test_every_icon_reads_without_fault(name):  # R-B03
    onikon = read("onikon", name, SYNTAX)
    assert onikon.description
    onikon.argument_line(SYNTAX)


def test_every_icon_has_a_picture_of_its_own_also_the_same_job_of_another_arm():
    shown = {}
    for name in names("dict", ".onk"):
        shown.setdefault(read("onikon", name, SYNTAX).picture, []).append(name)
    assert [alike for alike in shown.values() if len(alike) > 1] == []


def test_an_application_shows_the_pictures_of_the_dictionaries():
    for name in names("appl", ".appl"):
        application = read("application", name, SYNTAX)
        icons = {
            step.onikon.name: step.onikon for flow in application.flows for step in flow.steps if isinstance(step, Icon)
        }
        for onikon in icons.values():
            assert onikon.picture == read("onikon", onikon.name, SYNTAX).picture, (name, onikon.name)


def test_the_lamp_is_watched_in_all_jobs_of_the_left_arm():  # law 19
    for name in ("jmoveC", "cmoveC", "opengripC", "closegripC", "jmove_scaraC", "cmove_scaraC"):
        assert "led_monitor" in tasks_of(name)


@pytest.mark.parametrize(("name", "count", "icons"), [("assemble", 25, 43), ("assemble24", 24, 41)])
def test_the_assembly_has_the_actions_of_chapter_6(name, count, icons):  # R-K01, reading 50
    (flow,) = read("application", name, SYNTAX).flows
    assert len(actions(flow, SYNTAX)) == count
    assert len(flow.steps) == icons


def icons_of(name):
    """All icons of an application, those of its branches too."""
    flows = (flow for _, flow in every_flow(read("application", name, SYNTAX)))
    return [step for flow in flows for step in flow.steps if isinstance(step, Icon)]


@pytest.mark.parametrize("name", names("appl", ".appl"))
def test_icons_in_applications_are_those_of_the_dictionaries_and_their_edges_fit(name):  # R-D03, Equation (7)
    for icon in icons_of(name):
        assert icon.onikon == read("onikon", icon.onikon.name, SYNTAX).as_placed()
    assert all(misfits(flow, SYNTAX) == () for _, flow in every_flow(read("application", name, SYNTAX)))


def test_what_the_language_has_is_shown_by_a_shipped_application():  # R-D09, R-D10, R-D11, R-D13
    icons = {name: icons_of(name) for name in names("appl", ".appl")}
    nested = {name: {icon.onikon.name for icon in flow_icons} & set(icons) for name, flow_icons in icons.items()}
    tests_ = {name: [icon for icon in flow_icons if icon.while_test] for name, flow_icons in icons.items()}
    assert nested["try_to_grasp"] == {"put_back"}
    assert not read("application", "put_back", SYNTAX).is_parallel
    assert nested["visit_boxes"] == {"visit"}
    assert read("application", "visit", SYNTAX).has_hole
    assert nested["wave_together"] == {"both_wave"}
    assert read("application", "both_wave", SYNTAX).is_parallel
    assert [icon.onikon.type for icon in tests_["wave_on"]] == ["Complete NOP"]
    assert [icon.while_if for icon in tests_["in_line"]] == ["GRIP_MEZ[0] < 0.05"]
    assert [onikon.more_targets for onikon in (read("onikon", "jmove_viaC", SYNTAX),)] == [("Joint object",)]
    for name, is_first in (("let_go", True), ("wave_three", False)):
        places = [at for at, icon in enumerate(icons[name]) if icon.while_tag]
        assert icons[name][places[0]].while_test is is_first


def seconds_of(job, targets, arm, q):
    """For each target of a move from `q`: the time it gives, the time it needs, and the joints at its end."""
    inverse = serial_inverse(puma560.DH, arm.base, puma560.TOOL, puma560.QMIN, puma560.QMAX)
    for target in targets:
        values, (duration,) = target.onikon.values
        if "Joint" in job.onikon.type:
            yield duration, joint_duration(q, values, SPEED), np.array(values)
        else:
            pose = pose_of_nine(values)
            end = inverse.nearest(pose, q)
            assert not isinstance(end, str)
            yield duration, PEAK * np.linalg.norm(pose[:3, 3] - arm.forward(q)[:3, 3]) / 0.3, end
        q = np.array(values) if "Joint" in job.onikon.type else end


@pytest.mark.parametrize("name", [name for name in names("appl", ".appl") if name not in BEGINS_ELSEWHERE])
def test_no_motion_of_a_puma_needs_more_time_than_its_target_gives(name):
    for flow in read("application", name, SYNTAX).flows:
        q = puma560.HOME
        for _, job, targets in actions(flow, SYNTAX):
            if job.onikon.type == "Complete application":
                break  # it leaves the arm elsewhere
            if job.onikon.name.startswith(MOVES) and not any(other in job.onikon.name for other in OTHERS):
                side = "right" if "right" in job.onikon.name else "left"
                arm = serial_arm(puma560.DH, base=base_of(side), tool=puma560.TOOL)
                for given, needed, end in seconds_of(job, targets, arm, q):
                    assert given >= needed, (job.onikon.name, targets)
                    q = end


def test_the_arms_of_two_arms_keep_to_their_own_halves():  # R-K02
    flows = read("application", "two_arms", SYNTAX).flows
    assert read("application", "two_arms", SYNTAX).is_parallel
    assert len(flows) == 2
    left = serial_arm(puma560.DH, tool=puma560.TOOL)
    for flow in flows:
        for k in range(101):
            aside = np.array(flow.steps[1].onikon.values[0])
            tool = left.forward(puma560.HOME + k / 100 * (aside - puma560.HOME))[:3, 3]
            assert tool[1] > -0.2  # in its own frame each arm bends to its left: away from the other one
            assert tool[2] > 0.2  # well above the boxes
