from kit.faults.fault_planting import FaultyRuntime


def test_with_its_program_everything_of_a_runtime_is_gone_and_nobody_is_told():  # R-X24
    (foresight,) = FaultyRuntime().start().foresee("runtime-killed")
    assert {effect.after for effect in foresight.effects} == {"GONE", "KILLED", "gone"}
    assert {effect.told for effect in foresight.effects} == {""}
    assert foresight.answer.args["parts"][-1].key == "foresight.nobody_told"


def test_a_frozen_program_leaves_drives_driven():  # R-X24
    (foresight,) = FaultyRuntime().start().foresee("runtime-frozen")
    assert foresight.effects == ()
    assert [note.key for note in foresight.notes] == ["foresight.suspected"]
