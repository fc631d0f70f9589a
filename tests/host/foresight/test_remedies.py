from kit.faults.fault_planting import FaultyRuntime


def keys(foresight):
    return [reason.key for reason in foresight.to_do]


def test_a_flow_that_stands_offers_what_its_user_may_choose_then():  # R-X24, R-E08
    (foresight,) = FaultyRuntime(on_error="wait").start().foresee("task", "flow0/push")
    commands = [reason.args["command"] for reason in foresight.to_do]
    assert commands == ["clear", "next", "abort"]


def test_who_writes_is_cleared_before_the_device_that_it_feeds():  # R-X24
    (foresight,) = FaultyRuntime().start().foresee("task", "hand/push2")
    assert foresight.to_do[0].args["tasks"] == ("hand/push2", "hand/mass2")


def test_a_task_by_hand_is_cleared_and_a_lost_unit_needs_a_new_runtime():  # R-X24
    runtime = FaultyRuntime().start()
    assert keys(runtime.foresee("task", "hand/push2")[0]) == ["foresight.do_clear"]
    assert keys(runtime.foresee("unit-killed", "rt0")[0]) == ["foresight.do_run_again", "foresight.do_start_anew"]
