"""The box assembly in virtual time, right and wrong: only the right programs light the lamp (K01)."""

import json

import pytest

from kit.labs.laboratory import Laboratory, job, target
from kit.process.cli_process import CliProcess
from onika.cli import main
from onika.store.shipped import shipped
from onika.store.site import open_site

pytestmark = pytest.mark.site

SYNTAX = open_site([], {}, None).syntax()[0]
BOXES = open_site([], {}, None).at(shipped() / "boxes").directories[0]
OPEN, CLOSE = ("opengripC", ""), ("closegripC", "")
ABOVE_STACK = ("jmoveC", "box1_aj")
TRIANGLE, SQUARE, CROSS = 2, 3, 4


def carry(box, slot):
    """Fetch a box and put it on the stack where the box `slot` belongs."""
    return [
        ("jmoveC", f"box{box}_aj"),
        ("cmoveC", f"box{box}_bx"),
        CLOSE,
        ("jmoveC", f"box{box}_aj"),
        ABOVE_STACK,
        ("cmoveC", f"box{slot}_ex"),
        OPEN,
        ABOVE_STACK,
    ]


def assembly(*boxes):
    """The program with 25 actions, these boxes going to the three places from the bottom to the top."""
    return [
        OPEN,
        *(step for box, slot in zip(boxes, (TRIANGLE, SQUARE, CROSS), strict=True) for step in carry(box, slot)),
    ]


def without(program, *positions):
    return [step for number, step in enumerate(program) if number not in positions]


RIGHT = assembly(TRIANGLE, SQUARE, CROSS)


def icon(name):
    onikon = BOXES.onikon(name, SYNTAX)[0]
    return target(name, onikon.type, *(" ".join(map(repr, item)) for item in onikon.values))


def icons(program):
    kinds = {"jmoveC": "Joint job", "cmoveC": "Cartesian job"}
    for name, aim in program:
        yield job(name, kinds.get(name, "Complete job"))
        if aim:
            yield icon(aim)


def result_of(capsys, *words):
    code = main(["run", *words, "--json"])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert result["exit"] == code
    return result


def lamp_of(capsys, tmp_path, program):
    path = Laboratory(tmp_path).application("hand_made", list(icons(program)))
    result = result_of(capsys, str(path), "--virtual", "--expect", "LAMP == 1")
    assert (result["state"], result["actions_done"]) == ("completed", len(program))
    assert result["exit"] == (0 if result["values"]["LAMP"] else 1)
    return result["values"]["LAMP"]


@pytest.mark.parametrize(("name", "count"), [("assemble", 25), ("assemble24", 24)])
def test_the_shipped_assembly_lights_the_lamp(capsys, name, count):  # R-K01, R-E03, R-E14
    result = result_of(capsys, name, "--virtual", "--expect", "LAMP == 1", "--expect", "flow0/LAMP >= 1")
    assert (result["exit"], result["event"], result["state"]) == (0, "result", "completed")
    assert (result["actions_done"], result["actions"]) == (count, count)
    assert result["values"] == {"LAMP": 1, "flow0/LAMP": 1}
    assert set(result["missed"].values()) == {0}
    assert result["runtime_s"] > 10 > 0 < result["wall_s"]
    assert len(result["switches_us"]) == count - 1
    assert len(result["hash"]) == 64


def test_equal_programs_give_equal_hashes_whatever_the_hash_seed_of_python():  # R-X08, law 14
    hashes = set()
    for seed in ("1", "4711"):
        with CliProcess("run", "assemble", "--virtual", "--json", environment={"PYTHONHASHSEED": seed}) as console:
            hashes.add(console.result()["hash"])
    assert len(hashes) == 1


@pytest.mark.slow
def test_a_program_that_draws_no_random_numbers_is_the_same_with_any_seed(capsys):  # R-X08
    assert (
        result_of(capsys, "go_home", "--virtual", "--seed", "1")["hash"]
        == (result_of(capsys, "go_home", "--virtual", "--seed", "2")["hash"])
    )


def test_random_numbers_follow_the_seed_of_the_run(capsys, tmp_path):  # R-X08, law 14
    laboratory = Laboratory(tmp_path)
    laboratory.module(
        "dice",
        "from onika.module import Module, OutVar, finish\n"
        "class Dice(Module):\n"
        "    trigger = True\n"
        "    PIPS = OutVar('double', '-', 'what was thrown')\n"
        "    def cycle(self):\n"
        "        self.PIPS = self.random.random()\n"
        "        return finish() if self.now > 0.2 else None\n",
    )
    laboratory.plain_task("dice", writes="PIPS")
    laboratory.configuration("diceC", "dice 100")
    path = str(laboratory.application("throw", [job("diceC")]))
    first, again, other = (
        result_of(capsys, path, "--virtual", "--expect", "PIPS < 1", "--seed", seed)["values"]["PIPS"]
        for seed in ("1", "1", "2")
    )
    assert first == again
    assert first != other


def test_without_a_terminal_the_run_is_told_in_plain_lines(capsys):  # R-E11
    assert main(["run", "go_home", "--virtual", "--expect", "Q_MEZ[1] < -1.5"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "go_home: 1 action"
    assert lines[1].split() == ["0.00", "s", "1/1", "jmoveC", "home"]
    assert lines[2].startswith("go_home: completed, 1 of 1 actions, ")
    assert "expect Q_MEZ[1] < -1.5: yes" in lines
    assert not any("\x1b" in line for line in lines)


WRONG = [
    (3, 2, 4),
    *(pytest.param(order, marks=pytest.mark.slow) for order in [(2, 4, 3), (3, 4, 2), (4, 2, 3), (4, 3, 2)]),
]


@pytest.mark.parametrize("boxes", WRONG)
def test_boxes_in_a_wrong_order_leave_the_lamp_dark(capsys, tmp_path, boxes):  # R-K01
    assert lamp_of(capsys, tmp_path, assembly(*boxes)) == 0


def test_a_forgotten_open_at_the_beginning_leaves_the_lamp_dark_and_the_arm_stands_on_the_box(capsys, tmp_path):
    # R-K01, R-X06
    path = Laboratory(tmp_path).application("hand_made", list(icons(without(RIGHT, 0))))
    result = result_of(capsys, str(path), "--virtual", "--expect", "LAMP == 1")
    assert (result["exit"], result["state"], result["actions_done"]) == (1, "aborted", 1)
    assert not result["values"].get("LAMP")
    assert "the hand did not come to its target" in result["cause"]["text"]


@pytest.mark.parametrize(
    "place", [pytest.param(3, marks=pytest.mark.slow), 11, pytest.param(19, marks=pytest.mark.slow)]
)
def test_a_forgotten_close_leaves_the_lamp_dark(capsys, tmp_path, place):  # R-K01
    assert RIGHT[place] == CLOSE
    assert lamp_of(capsys, tmp_path, without(RIGHT, place)) == 0


@pytest.mark.slow
def test_no_approach_before_the_first_grasp_leaves_the_lamp_dark(capsys, tmp_path):  # R-K01
    path = Laboratory(tmp_path).application("hand_made", list(icons(without(RIGHT, 1))))
    result = result_of(capsys, str(path), "--virtual", "--expect", "LAMP == 1")
    assert result["exit"] == 1
    assert not result["values"].get("LAMP")  # the straight line passes a posture that no joint is quick enough for


def test_no_retreat_after_the_second_release_leaves_the_lamp_dark(capsys, tmp_path):  # R-K01
    assert RIGHT[15:17] == [OPEN, ABOVE_STACK]
    assert lamp_of(capsys, tmp_path, without(RIGHT, 16)) == 0


def test_straight_from_pick_to_place_leaves_the_lamp_dark(capsys, tmp_path):  # R-K01
    assert RIGHT[4:6] == [("jmoveC", "box2_aj"), ABOVE_STACK]
    assert lamp_of(capsys, tmp_path, without(RIGHT, 4, 5)) == 0


def test_a_lift_that_nothing_hangs_on_may_be_left_out(capsys, tmp_path):  # R-K01
    assert lamp_of(capsys, tmp_path, without(RIGHT, 4)) == 1


def test_without_an_expectation_a_dark_lamp_is_nobodys_fault(capsys, tmp_path):  # R-E14
    path = Laboratory(tmp_path).application("half", list(icons(RIGHT[:9])))
    result = result_of(capsys, str(path), "--virtual")
    assert (result["exit"], result["state"], result["values"]) == (0, "completed", {})
