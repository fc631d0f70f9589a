"""How each planted fault is mended in the page, by what a learner would do there."""

from collections.abc import Callable

from .learner import Learner


def empty_hand(me: Learner) -> None:
    """What opens at the box closes there."""
    me.exchanges(6, "closegripC")


def open_hole(me: Learner) -> None:
    me.icon("box2_bx").click()
    me.holes.click(button="right")


def out_of_reach(me: Learner) -> None:
    """The target of the same name that stands in the dictionary."""
    me.exchanges(3, "box2_aj")


def shut_hand(me: Learner) -> None:
    me.exchanges(1, "opengripC")


def ten_steps(me: Learner) -> None:
    me.exchanges(me.place_of("repeatC") + 1, "three")


def borrowed_arm(me: Learner) -> None:
    """The arm of the second flow is another one; its target stays."""
    me.exchanges(me.places_of("jmoveC")[1], "jmove_rightC")


def one_step(me: Learner) -> None:
    """What is to be repeated stands between the ends of the loop."""
    job = me.place_of("cshiftC")
    me.takes_out(job, job + 1)
    me.puts(me.place_of("noop"), "cshiftC", "up_10cm")


def swapped_flows(me: Learner) -> None:
    """Each flow of the branch gets what stood in the other."""
    job = me.places_of("jmoveC")[-1]
    me.puts(job + 1, "opengripC")
    me.takes_out(job, job + 1)
    last = me.places_of("opengripC")[-1]
    me.puts(last, "jmoveC", "aside")
    me.takes_out(last)


def wrong_way(me: Learner) -> None:
    me.conditions("GRIP_MEZ[0] > 0.07")


def crossed_tags(me: Learner) -> None:
    """Both flows meet in one order: the two tags of the second one change places."""
    first, second = me.places_of("jmove_rightC")[0], me.places_of("opengrip_rightC")[0]
    me.tags(first, "arms")
    me.tags(second, "hands")


def no_waiting(me: Learner) -> None:
    me.tags(me.places_of("jmoveC")[0], "free")
    me.tags(me.place_of("opengrip_rightC"), "free")


def waving(me: Learner) -> None:
    """A plain motion in place of the program that waves."""
    at = me.place_of("visit")
    me.takes_out(at, at + 1)
    me.puts(at - 1, "jmoveC", "box1_aj")


MENDINGS: dict[str, Callable[[Learner], None]] = {
    mending.__name__: mending
    for mending in (
        empty_hand, open_hole, out_of_reach, shut_hand, ten_steps, borrowed_arm, one_step, swapped_flows, wrong_way,
        crossed_tags, no_waiting, waving,
    )
}  # fmt: skip
"""By the name of the puzzle."""
