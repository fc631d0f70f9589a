from onika.words.argument import split


def test_readings_are_written_with_time_subsystem_name_type_and_values(sit, tmp_path):  # R-A12
    sitting = sit()
    sitting.does("spawn puma", "spawn left/puma")
    sitting.runtime.variables = {"main": {"Q_MEZ": [0.1, 2.0], "ROBOT": "PUMA 560"}, "left": {"NDOF": 6}}
    sitting.runtime.now_s = 1.5
    path = tmp_path / "now.log"
    assert sitting.does(f"log {path}") == [f"{path}: 3 variables"]
    rows = [split(line) for line in path.read_text().splitlines() if not line.startswith("#")]
    assert rows == [
        ["1.500000", "main", "Q_MEZ", "double[2]", "0.1", "2.0"],
        ["1.500000", "main", "ROBOT", "string", "PUMA 560"],
        ["1.500000", "left", "NDOF", "int", "6"],
    ]
    assert sitting.does(f"log {path} left") == [f"{path}: 1 variable"]
    assert "main" not in path.read_text()


def test_a_file_that_cannot_be_written_is_told_and_nothing_is_left(sit, tmp_path):
    sitting = sit()
    sitting.does("spawn puma")
    fault = sitting.fails(f"log {tmp_path}/none/now.log")
    assert str(fault.instead) == "nothing is written"
    sitting.runtime.refusals["Read"] = "not yours"
    assert str(sitting.fails(f"log {tmp_path}/x.log").reason) == "expected variables of main, found not yours"
    assert list(tmp_path.iterdir()) == []
