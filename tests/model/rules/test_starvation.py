from onika.model.lifecycle import State
from onika.model.rules.order import Ports
from onika.model.rules.starvation import starved, writer_failed


def task(name, reads="", writes=""):
    return Ports(name, invar=tuple(reads.split()), outvar=tuple(writes.split()))


TRIGGER = task("jtraj", "Q_MEZ", "Q_REF")
SERVO = task("pd", "Q_REF Q_MEZ", "TAU_PD")
ARM = task("puma", "TAU_PD", "Q_MEZ")
GRIPPER = task("grip", "GRIP_REF")
MONITOR = task("seen", "Q_REF", "SEEN")
EVERYBODY = [ARM, GRIPPER, TRIGGER, SERVO, MONITOR]
HARDWARE = {"puma", "grip"}


def test_hardware_that_reads_what_a_failed_task_wrote_is_starved():  # law 4
    assert starved(SERVO, EVERYBODY, HARDWARE) == {"puma": "TAU_PD"}


def test_so_is_hardware_that_it_reaches_through_others_named_by_what_the_failed_one_wrote():  # law 4
    assert starved(TRIGGER, EVERYBODY, HARDWARE) == {"puma": "Q_REF"}


def test_the_order_of_the_tasks_is_of_no_matter():  # law 4
    assert starved(TRIGGER, EVERYBODY[::-1], HARDWARE) == {"puma": "Q_REF"}


def test_who_is_not_there_passes_nothing_on():  # law 4
    assert starved(TRIGGER, [ARM, GRIPPER, MONITOR], HARDWARE) == {}


def test_nobody_is_starved_by_a_task_whose_values_reach_no_hardware():  # law 4
    assert starved(MONITOR, EVERYBODY, HARDWARE) == {}


def test_nothing_comes_through_hardware_and_nobody_starves_itself():  # law 4
    follower = task("follower", "Q_MEZ")
    assert starved(SERVO, [*EVERYBODY, follower], {*HARDWARE, "follower"}) == {"puma": "TAU_PD"}
    assert starved(ARM, EVERYBODY, HARDWARE) == {}
    assert starved(ARM, [*EVERYBODY, follower], {*HARDWARE, "follower"}) == {"follower": "Q_MEZ"}


def test_why_a_device_is_not_driven_on_names_task_variable_and_state():  # law 4
    said = str(writer_failed("pd", "TAU_PD", State.ERROR))
    assert said == "task pd, which wrote TAU_PD, is ERROR: the device is not driven on with that"
