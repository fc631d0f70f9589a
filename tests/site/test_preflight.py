"""Pairs of robots and programs, sound ones and ones with something planted in them, looked at before the run (X02)."""

import pytest

from kit.labs.laboratory import job, joints
from kit.plans.preflight_cases import (
    ASIDE,
    BEYOND,
    FAR,
    HOME,
    LEANS,
    MODES,
    NOT_THERE,
    ONE_DEVICE,
    PLANTED,
    lined,
    moved,
    own,
)
from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.model.redirect import Redirect
from onika.store.site import open_site

pytestmark = [pytest.mark.site, pytest.mark.usefixtures("warm_runtimes")]

SHIPPED = [
    # what stands for the puma, program, everything that is to be said
    ("puma", "assemble", []),
    ("puma", "assemble24", []),
    ("puma", "assemble_together", []),
    ("puma", "both_wave", []),
    ("puma", "by_way_of", []),
    ("puma", "in_line", []),
    ("puma", "let_go", []),
    ("puma", "put_back", []),
    ("puma", "try_to_grasp", []),
    ("puma", "wave_on", []),
    ("puma", "wave_together", []),
    ("puma_kin", "assemble", []),
    ("puma_kin", "by_way_of", []),
    ("puma_kin", "in_line", []),
    ("puma_kin", "let_go", []),
    ("puma_kin", "try_to_grasp", []),
    ("puma_kin", "visit_boxes", []),
    ("puma_kin", "assemble_together", [MODES]),
    ("puma_kin", "both_wave", [MODES]),
    ("puma_kin", "wave_three", [NOT_THERE]),
    ("scara", "assemble", []),
    ("scara", "assemble24", []),
    ("scara", "put_back", []),
    ("scara", "go_home", [f"home: {LEANS} 180 degrees"]),
    ("scara", "assemble_together", [f"action 18: {HOME}"]),
    ("scara", "both_wave", [f"action 1: {ASIDE}"]),
    ("scara", "by_way_of", ["action 1: jmove_viaC aside box2_aj", f"action 2: {HOME}"]),
    ("scara", "in_line", [ASIDE, HOME]),
    ("scara", "let_go", [f"action 8: {HOME}"]),
    ("scara", "two_arms", [f"action 1: {ASIDE}", f"action 2: {HOME}"]),
    ("scara", "wave_together", [f"action 1 of both_wave: {ASIDE}", f"action 4: {HOME}"]),
    ("scara", "wave_three", [NOT_THERE]),
    ("scara_kin", "assemble", []),
    ("scara_kin", "put_back", []),
    ("scara_kin", "two_arms", [ASIDE, HOME, MODES]),
    ("puma_right", "assemble", []),
    ("puma_right", "go_home", [f"home: out of reach: {FAR} 1.537 m"]),
    ("puma_right", "two_arms", [ASIDE, HOME, ONE_DEVICE]),
    ("gripper", "assemble", ["does not write BASE, ", "reads GRIP, which no task of `jmoveC` writes", "of `cmoveC`"]),
    ("jtraj", "go_home", ["does not write BASE", "takes the target of a Joint job", "reads NDOF, QMAX"]),
    ("closegripC", "go_home", ["no closegripC"]),
]


@pytest.fixture(scope="module")
def loading():
    return ModuleFacts()


def sentences_before_the_run(loading, name, local=(), redirects=()):
    """Everything that is said of a program before it runs."""
    site = open_site(local, {}, None)
    prepared = prepare_run(str(name), site, tuple(map(Redirect.parse, redirects)))
    faults = list(prepared.faults)
    if prepared.plan is not None:
        faults += [fault for fault in prepare(prepared.plan, prepared.targets, loading).faults if fault not in faults]
    return [str(fault) for fault in faults]


def assert_told(sentences, expected):
    """Each thing that is expected is said once, and nothing else; those in a tuple of whoever lacks them."""
    if isinstance(expected, tuple):
        assert all(any(sentence in text for sentence in expected) for text in sentences)
        assert all(any(sentence in text for text in sentences) for sentence in expected)
        return
    left = list(sentences)
    for sentence in expected:
        match = next((text for text in left if sentence in text), None)
        assert match is not None, f"{sentence!r} is not said: {left}"
        left.remove(match)
    assert left == []


@pytest.mark.parametrize(
    ("robot", "program", "expected"), SHIPPED, ids=lambda value: value if isinstance(value, str) else ""
)
def test_a_program_on_another_robot_is_refused_for_what_is_wrong_and_for_nothing_else(
    loading, robot, program, expected
):  # R-X02, R-E09
    redirects = () if robot == "puma" else (f"puma={robot}",)
    assert_told(sentences_before_the_run(loading, program, redirects=redirects), expected)


@pytest.mark.parametrize("case", PLANTED)
def test_what_is_planted_is_told_with_its_place_and_nothing_else_is(loading, tmp_path, case):  # R-X02
    make, redirects, expected = PLANTED[case]
    assert_told(sentences_before_the_run(loading, make(tmp_path), [tmp_path], redirects), expected)


def test_there_are_more_than_fifty_pairs_and_many_of_them_are_sound():  # R-X02
    sound = [expected for *_, expected in (*SHIPPED, *PLANTED.values()) if not expected]
    assert len(SHIPPED) + len(PLANTED) >= 50
    assert len(sound) >= 20


def test_everything_is_told_at_once_whatever_it_is(loading, tmp_path):  # R-X02
    steps = [*moved(joints("far", *BEYOND)), *lined("0 0 -1 0 1 0 1.9 0.2 -0.3"), job("nowhereC")]
    path = own("p", steps, puma={"BASE": "0.1 0 0 0"}, led_monitor={"DEVICE": "boxes:bulb"})(tmp_path)
    sentences = sentences_before_the_run(loading, path, [tmp_path])
    elsewhere, nowhere = "expected frame 0 of the robot at", "the configuration nowhereC"
    assert_told(sentences, ["far: joint 3", "p0: out of reach", elsewhere, "boxes:bulb", nowhere])


def test_the_hand_of_the_other_arm_is_worth_a_note(loading):  # R-X02, R-E09
    for redirect, count in (("puma=puma_right", 1), ("puma=scara", 0), ("puma=puma_kin", 0)):
        prepared = prepare_run("assemble", open_site([], {}, None), (Redirect.parse(redirect),))
        notes = [
            note for note in prepare(prepared.plan, prepared.targets, loading).notes if "is the hand at" in str(note)
        ]
        assert len(notes) == count
        assert all("gripper.rmod: gripper_left is the hand at the left" in str(note) for note in notes)
