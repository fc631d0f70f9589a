from onika.desk.run.world_text import drive_lines


def lines(worlds, simulated):
    return [str(line) for line in drive_lines(worlds, simulated)]


def test_where_all_are_in_one_simulated_world_nothing_is_told():  # R-E09
    assert lines({"flow0": ("boxes",), "flow1": ("boxes",)}, {"boxes": True}) == []
    assert lines({"flow0": ()}, {}) == []


def test_one_arm_real_and_the_other_simulated_are_told_apart():  # R-E09
    worlds = {"flow0": ("cell",), "flow1": ("boxes", "cell"), "flow2": ()}
    assert lines(worlds, {"cell": False, "boxes": True}) == [
        "flow0 drives cell (real)",
        "flow1 drives boxes (simulated) and cell (real)",
    ]


def test_a_real_world_is_told_even_alone_and_one_that_nobody_knows_is_only_named():  # R-E09
    assert lines({"main": ("cell",)}, {"cell": False}) == ["main drives cell (real)"]
    assert lines({"a": ("cell",), "b": ("sea",)}, {"cell": True}) == ["a drives cell (simulated)", "b drives sea"]
