from onika.desk.run.readings_text import rows
from onika.wire.live import Values


def test_a_type_that_the_runtime_says_counts_more_than_the_look_of_a_value():
    values = Values({"X": 1.0, "Y": 1.0}, 0.0, {"X": "float"})
    assert rows("main", values) == ["0.000000 main X float 1.0", "0.000000 main Y double 1.0"]
