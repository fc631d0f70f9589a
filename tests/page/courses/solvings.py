"""How each puzzle is solved in the page, by what a learner would do there."""

from collections.abc import Callable

from .learner import Learner

TAKEN = ("opengripC", "jmoveC", "box2_aj", "cmoveC", "box2_bx", "closegripC", "jmoveC", "box2_aj")
"""The box with the triangle, taken and lifted."""

PUT_DOWN = ("jmoveC", "box1_aj", "cmoveC", "box2_ex", "opengripC", "jmoveC", "box1_aj")
"""And put where it belongs."""

STACKED = (
    "jmoveC", "box4_aj", "cmoveC", "box4_bx", "closegripC", "jmoveC", "box4_aj",
    "jmoveC", "box1_aj", "cmoveC", "box4_ex", "opengripC", "jmoveC", "box1_aj",
)  # fmt: skip
"""The box with the cross, taken and put on top."""

BROUGHT = (
    "opengrip_rightC", "jmove_rightC", "box3_ajr", "cmove_rightC", "box3_bx", "closegrip_rightC", "jmove_rightC",
    "box3_ajr", "jmove_rightC", "box1_ajr", "cmove_rightC", "box3_ex", "opengrip_rightC", "jmove_rightC", "box1_ajr",
    "jmove_rightC", "box3_ajr", "jmove_rightC", "aside", "jmove_rightC", "home",
)  # fmt: skip
"""The box with the square, by the right arm, which goes away from the stack then."""


def swing_aside(me: Learner) -> None:
    me.puts(0, "jmoveC", "aside")


def hold_triangle(me: Learner) -> None:
    me.puts(0, *TAKEN)


def climb(me: Learner) -> None:
    """One step up, which is repeated."""
    me.puts(0, "jmoveC", "box2_aj", "cshiftC", "up_10cm")
    me.repeats(3, 1, 3)


def block_on_pad(me: Learner) -> None:
    me.puts(
        0, "gripper_gantryC", "open_wide", "jmove_gantryC", "over_block", "jmove_gantryC", "at_block",
        "gripper_gantryC", "on_block", "jmove_gantryC", "over_block", "jmove_gantryC", "over_pad",
        "jmove_gantryC", "at_pad", "gripper_gantryC", "open_wide",
    )  # fmt: skip


def scara_square(me: Learner) -> None:
    me.puts(
        0, "opengripC", "cmove_scaraC", "over_box3", "cmove_scaraC", "box3_bx", "closegripC", "cmove_scaraC",
        "over_box3",
    )  # fmt: skip


def both_hands(me: Learner) -> None:
    """Each arm in a flow of its own."""
    me.adds_a_flow()
    me.puts(0, *TAKEN)
    second = len(TAKEN) + 2
    me.puts(second, *BROUGHT[:8])


def light_the_lamp(me: Learner) -> None:
    """What was done with one box is copied for the next, and the targets are exchanged."""
    me.puts(0, *TAKEN, *PUT_DOWN)
    last = len(TAKEN) + len(PUT_DOWN)
    for box in ("box3", "box4"):
        me.copies(2, last, behind=me.steps.count() - 2)
        first = me.steps.count() - last
        for place, ending in ((1, "aj"), (3, "bx"), (6, "aj"), (10, "ex")):
            me.exchanges(first + place, f"{box}_{ending}")


def stack_together(me: Learner) -> None:
    """Who has put a box down goes away before the other comes; all icons are in sight."""
    me.page.set_viewport_size({"width": 1900, "height": 1300})
    me.adds_a_flow()
    me.puts(0, *TAKEN, *PUT_DOWN, *STACKED)
    second = len(TAKEN) + len(PUT_DOWN) + len(STACKED) + 2
    me.puts(second, *BROUGHT)
    me.tags(18, "triangle")
    me.tags(second + 9, "triangle")
    me.tags(23, "square")
    me.tags(second + 18, "square")


SOLVINGS: dict[str, Callable[[Learner], None]] = {
    solving.__name__: solving
    for solving in (
        swing_aside, hold_triangle, climb, block_on_pad, scara_square, both_hands, light_the_lamp, stack_together,
    )
}  # fmt: skip
"""By the name of the puzzle."""
