from hashlib import sha256

import pytest

from kit.plans.plan_builder import PlanBuilder
from onika.desk.plan.claimed_devices import faults, moves_a_device
from onika.wire.plan import Code, Plan, PlannedFlow
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason

DRIVES = "from onika.module import *\n\nclass Drives(Module):\n    hardware = True\n"
LISTENS = "from onika.module import *\n\nclass Listens(Module):\n    pass\n"


def plan_of(*flows):
    """Each flow as `task device` pairs, in capitals where the module drives the device."""
    builder, planned = PlanBuilder(), []
    for number, pairs in enumerate(flows):
        tasks = []
        for name, device in pairs:
            source = DRIVES if name.isupper() else LISTENS
            tasks.append(builder.task(name, source, local={"DEVICE": device} if device else {}))
        planned.append(PlannedFlow(f"flow{number}", tuple(tasks), ()))
    code = tuple(Code(sha256(source.encode()).hexdigest(), "m", "m.py", source) for source in (DRIVES, LISTENS))
    return Plan("play", tuple(planned), code)


def test_two_flows_that_drive_one_device_are_told_before_a_runtime_is_asked():  # R-E01, R-C18, law 16
    plan = plan_of([("ARM", "cell:left")], [("OTHER", "cell:left"), ("ARM", "cell:left")])
    claimed = Reason.of("host.device_claimed", device="cell:left", other="ARM")
    second = plan.flows[1].tasks
    assert list(faults(plan)) == [Fault(Place(task.place), claimed, NOT_RUN) for task in second]


def test_who_only_listens_and_who_drives_another_device_is_nobodys_rival():  # law 16
    assert not list(
        faults(plan_of([("ARM", "cell:left")], [("logger", "cell:left"), ("ARM", "cell:right"), ("PD", "")]))
    )


def test_what_stands_in_one_flow_is_told_by_the_rules_of_that_flow():
    assert not list(faults(plan_of([("ARM", "cell:left"), ("OTHER", "cell:left")])))


@pytest.mark.parametrize(
    ("source", "is_so"),
    [
        (DRIVES, True),
        (LISTENS, False),
        ("class A:\n    hardware: ClassVar[bool] = True\n", True),
        ("class A:\n    hardware = False\n", False),
        ("hardware = True\n", False),
        ("class A(:\n", False),
    ],
)
def test_a_module_says_in_its_text_whether_it_moves_a_device(source, is_so):
    assert moves_a_device(source) is is_so
