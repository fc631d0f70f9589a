from kit.faults.fault_planting import FaultyRuntime


def test_a_runtime_ends_with_the_program_that_launched_it():  # R-X24, R-A15
    runtime = FaultyRuntime().start()
    runtime.server.launcher = "me"
    (foresight,) = runtime.foresee("environment", "me")
    assert ("runtime", "GONE") in {(effect.kind, effect.after) for effect in foresight.effects}
    assert ("link", "me") not in runtime.questions()


def test_a_task_that_does_not_look_at_its_drive_is_said_to_go_on():  # R-X24
    runtime = FaultyRuntime()
    source = runtime.shop.code("mass").source.replace("self.check_drive()", "pass")
    runtime.shop.task("mass", source, frequency=500.0, local={"DEVICE": "yard:m0"}, rtpu="rt0")
    (foresight,) = runtime.start(by_hand=False).foresee("button", "yard:m0")
    assert [effect.after for effect in foresight.effects] == ["PRESSED"]
    assert [note.key for note in foresight.notes] == ["foresight.overlooked"]
