from hashlib import sha256

import numpy as np
import pytest
from msgspec import structs

from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.pose_solution import solve
from onika.laws import reach
from onika.store.site import open_site
from onika.wire import live, request
from onika.wire.plan import Code

DOWN = (0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.4, 0.3, 0.2)
FAR = (*DOWN[:6], 4.0, 0.3, 0.2)


@pytest.fixture(scope="module")
def arm():
    """The task of the left arm, and its code."""
    plan = prepare_run("go_home", open_site([], {}, None)).plan
    task = next(task for task in plan.flows[0].tasks if task.name == "puma")
    return task, next(code for code in plan.code if code.digest == task.digest)


def test_the_joints_of_a_pose_bring_the_tool_there_and_what_is_too_far_says_why(arm):  # R-D25, law 26
    task, code = arm
    solved = solve(live.Solve(code, task.local, (FAR, DOWN)), ModuleFacts())
    assert solved.joints[0] == () and "reach" in str(solved.reasons[0])
    constants = ModuleFacts().constants(code, task.local)
    assert np.allclose(reach.poses(constants, [solved.joints[1]])[0], DOWN, atol=1e-9)
    assert not solved.reasons[1]


def test_a_module_that_knows_no_poses_says_so(arm):  # R-D25
    source = "from onika.module import Module\n\nclass Still(Module):\n    pass\n"
    still = Code(sha256(source.encode()).hexdigest(), "still", "still.py", source)
    refused = solve(live.Solve(still, (), (DOWN,)), ModuleFacts())
    assert isinstance(refused, request.Refused) and "still knows of no poses" in str(refused.reason)


def test_code_under_the_digest_of_another_is_not_executed(arm):  # R-F01, law 24
    task, code = arm
    refused = solve(live.Solve(structs.replace(code, source="raise SystemExit"), task.local, (DOWN,)), ModuleFacts())
    assert "digest" in str(refused.reason)


def test_an_arm_whose_lines_are_wrong_is_refused(arm):
    _, code = arm
    refused = solve(live.Solve(code, (("ROBOT", ("toaster",)),), (DOWN,)), ModuleFacts())
    assert isinstance(refused, request.Refused)
