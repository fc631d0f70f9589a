from pathlib import Path

from severing import trails

MS = 1_000_000


def steps(*rows):
    return [(what, step, at_ms * MS) for what, step, at_ms in rows]


def test_who_begins_together_is_never_alone():
    own = steps(("begin", 0, 1000), ("cycle", 0, 1010), ("done", 0, 1600), ("begin", 1, 2000))
    assert trails.segments(own) == [(0, 1000 * MS, 1600 * MS), (1, 2000 * MS, 2000 * MS)]
    assert trails.joined(steps(("begin", 0, 1002)), 0, 1000 * MS) == 1002 * MS
    assert trails.skews([own, steps(("begin", 0, 1002)), steps(("begin", 0, 999))]) == [3000.0]


def test_who_begins_and_finds_nobody_is_alone_until_he_is_held():
    before = steps(("begin", 0, 500), ("cycle", 0, 510))  # a former try, which was held
    assert trails.joined(before, 0, 1000 * MS) == 2**63
    assert trails.joined(before + steps(("begin", 0, 1300)), 0, 1000 * MS) == 1300 * MS


def test_who_has_done_a_step_has_been_there():
    assert trails.joined(steps(("begin", 0, 300), ("done", 0, 900)), 0, 1000 * MS) == 1000 * MS
    assert trails.joined(steps(("begin", 1, 990)), 0, 1000 * MS) == 1000 * MS


def test_half_a_line_of_a_killed_flow_is_left_out(tmp_path: Path):
    (tmp_path / "flow").write_text("begin 0 5\ncycle 0")
    assert trails.trail(tmp_path / "flow") == [("begin", 0, 5)]
    assert trails.trail(tmp_path / "none") == []
