from dataclasses import replace

import pytest

from kit.desk.dictionary_fixture import DictionaryFixture, plain
from onika.desk.environment.icons.arm_fit import hardware_before, is_of_another_arm
from onika.model.application import AppFlow, Branch, Hole, Icon
from onika.wire import act

JOINTS = ((0.0, -1.5, 1.5, 0.0, 0.0, 0.0), (2.0,))
TARGET = Icon(plain("t", "Joint object"))


@pytest.fixture
def cabinet(tmp_path):
    """With a target of each arm, and one of any."""
    mine = (replace(plain(name, "Joint object", name, *JOINTS), arm=arm) for name, arm in ARMS.items())
    return DictionaryFixture(tmp_path, *mine)


ARMS = {"of_left": "puma", "of_right": "puma_right", "of_any": ""}


def hardware(cabinet, *steps):
    model = cabinet.environment.model
    return hardware_before(model, model.syntax, AppFlow(steps), len(steps) - 1)


def test_the_arm_of_a_place_is_that_of_the_job_before_it_across_its_targets(cabinet):  # R-D08
    right, via = Icon(plain("jmove_rightC", "Joint job")), Icon(plain("jmove_viaC", "Joint job"))
    assert "puma_right" in hardware(cabinet, via, TARGET, right)
    assert "puma" in hardware(cabinet, right, via, TARGET)
    for steps in ((), (right, Hole()), (right, Branch(())), (TARGET,), (Icon(plain("nobody", "Joint job")),)):
        assert hardware(cabinet, *steps) == ()


def test_a_target_belongs_to_another_arm_only_where_both_are_known():  # R-D08
    made = replace(plain("t", "Joint object"), arm="puma")
    assert is_of_another_arm(made, ("puma_right", "led_monitor"))
    assert not is_of_another_arm(made, ("puma", "led_monitor"))
    assert not is_of_another_arm(made, ())
    assert not is_of_another_arm(replace(made, arm=""), ("puma_right",))


def test_what_is_offered_behind_a_job_leaves_out_targets_of_another_arm(cabinet):  # R-D08, R-X01
    doc = cabinet.do(act.NewApplication(1))
    right = cabinet.do(act.InsertIcon(doc, "jmove_rightC", "0", 0))
    used = [str(remedy.label) for remedy in cabinet.no(act.InsertIcon(doc, "opengripC", "0", right)).remedies]
    assert "Use of_right" in used and "Use of_left" not in used
    cabinet.do(act.InsertIcon(doc, "of_left", "0", right))  # who means it may


def test_the_page_knows_the_arm_of_a_target_and_the_devices_of_a_job(cabinet):  # R-D08
    assert {name: cabinet.icon(name).arm for name in ARMS} == ARMS
    assert "puma_right" in cabinet.icon("jmove_rightC").hardware
    assert "puma" not in cabinet.icon("jmove_rightC").hardware
    assert cabinet.icon("home").hardware == () and cabinet.icon("put_back").hardware == ()
