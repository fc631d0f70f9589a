from kit.faults.fault_planting import FaultyRuntime


def keys(foresight):
    return [reason.key for reason in foresight.to_do]


def test_a_flow_that_stands_offers_what_its_user_may_choose_then():  # R-X24, R-E08
    (foresight,) = FaultyRuntime(on_error="wait").start().foresee("task", "flow0/push")
    commands = [reason.args["command"] for reason in foresight.to_do]
    assert commands == ["clear", "next", "abort"]


def test_a_task_by_hand_is_cleared_and_a_lost_unit_needs_a_new_runtime():  # R-X24
    runtime = FaultyRuntime().start()
    assert keys(runtime.foresee("task", "hand/push2")[0]) == ["foresight.do_clear"]
    assert keys(runtime.foresee("unit-killed", "rt0")[0]) == ["foresight.do_run_again", "foresight.do_start_anew"]
