from kit.faults.fault_planting import FaultyRuntime
from onika.words.reason import in_language


def test_the_answer_is_one_sentence_that_begins_with_what_moves():  # R-X24
    (foresight,) = FaultyRuntime().start().foresee("unit-killed", "rt0")
    keys = [part.key for part in foresight.answer.args["parts"]]
    assert keys[0] == "foresight.drives_trip"
    assert keys[-1] == "foresight.all_told"
    assert in_language(foresight.answer, "es").startswith("yard:m0 y yard:m1 han saltado en 60 ms")


def test_where_nothing_changes_the_answer_says_what_goes_on():  # R-X24
    (foresight,) = FaultyRuntime().start().foresee("browser")
    assert foresight.effects == ()
    keys = [part.key for part in foresight.answer.args["parts"]]
    assert keys == ["foresight.drives_driven", "foresight.run_goes_on"]
