from kit.faults.fault_planting import FaultyRuntime


def test_a_plan_is_answered_at_its_first_step_before_anything_runs():  # R-X24
    runtime = FaultyRuntime()
    runtime.prepare()
    (planned,) = runtime.foresee("unit-frozen", "rt0", is_planned=True)
    assert runtime.changes() == []
    runtime.start(by_hand=False)
    (present,) = runtime.foresee("unit-frozen", "rt0")
    drives = [effect for effect in present.effects if effect.subject == "yard:m0"]
    assert [effect for effect in planned.effects if effect.kind == "drive"] == drives
    assert [effect.after for effect in drives] == ["HELD", "TRIPPED"]
    assert {effect.subject for effect in planned.effects} == {effect.subject for effect in present.effects}


def test_it_is_answered_as_the_plan_would_be_begun():  # R-X24, R-E08
    runtime = FaultyRuntime()
    runtime.prepare()
    (aborts,) = runtime.foresee("task", "flow0/push", is_planned=True)
    (waits,) = runtime.foresee("task", "flow0/push", is_planned=True, on_error="wait")
    assert [effect.kind for effect in aborts.effects][-1] == "run"
    assert [effect.after for effect in waits.effects if effect.kind == "flow"] == ["stopped"]
