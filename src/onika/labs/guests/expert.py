"""An expert system of one rule as a guest: it decides which box is stacked next, and when the tower is done.

    python -m onika.labs.guests.expert tcp:127.0.0.1:7806

A goal is made of clauses such as `square on triangle`, in any order. The rule: a box whose support stands and which
does not stand itself is the next one. It knows that the lamp is lit as soon as all four boxes stand on each other.
"""

import sys
from contextlib import suppress

from onika.guest import ActionResult, Errand, GuestError, GuestProgram, action

BOXES = ("triangle", "square", "cross")
"""The boxes that the arm can fetch; the number of each is the flow that fetches it."""
GROUND = "waves"
"""The box on which the tower is built."""


class Expert(GuestProgram):
    """It remembers the goal and what stands already; one tower at a time."""

    name = "expert"

    def __init__(self) -> None:
        self.wanted: dict[str, str] = {}
        self.standing: list[str] = [GROUND]

    @action
    def learn(self, errand: Errand) -> None:
        """Take in a goal, and refuse one that cannot be reached."""
        self.wanted = clauses(str(errand.target.get("goal", "")))
        self.standing = [GROUND]
        lost = sorted(set(self.wanted) - set(self.order()))
        if lost:
            raise GuestError(f"nothing leads from the box with the {GROUND} to that with the {lost[0]}")

    @action
    def which(self, _errand: Errand) -> ActionResult:
        """The flow that fetches the next box."""
        box = self.follows(self.standing)
        if box is None:
            raise GuestError("there is nothing to be stacked: learn a goal first")
        return ActionResult(flow=BOXES.index(box))

    @action
    def judge(self, errand: Errand) -> ActionResult:
        """The box stands now; round again while another one follows. At the end of a whole tower the lamp is lit."""
        box = self.follows(self.standing)
        if box is not None:
            self.standing.append(box)
        goes_on = self.follows(self.standing) is not None
        is_whole = set(BOXES) <= set(self.standing)
        if not goes_on and is_whole and not errand.values.get("LAMP"):
            raise GuestError("all boxes should stand on each other now, and the lamp is dark")
        return ActionResult(loop=goes_on)

    @action
    def report(self, _errand: Errand) -> ActionResult:
        """Say what stands, and what is to come, from the ground up."""
        standing, coming = " < ".join(self.standing), " < ".join(self.order()[len(self.standing) :])
        return ActionResult(says=f"{standing} stands" + (f", then {coming}" if coming else ""))

    def order(self) -> list[str]:
        """The boxes as they will stand in the end, from the ground up."""
        order = [GROUND]
        while (box := self.follows(order)) is not None:
            order.append(box)
        return order

    def follows(self, standing: list[str]) -> str | None:
        """The rule."""
        ready = [box for box, below in self.wanted.items() if below == standing[-1] and box not in standing]
        return ready[0] if ready else None


def clauses(goal: str) -> dict[str, str]:
    """On what each box shall stand; raises GuestError for what it does not understand."""
    wanted: dict[str, str] = {}
    for clause in goal.split(","):
        match clause.split():
            case [box, "on", below] if box in BOXES and below in (*BOXES, GROUND) and box not in wanted:
                wanted[box] = below
            case _:
                known = ", ".join((*BOXES, GROUND))
                raise GuestError(f"expected clauses as 'square on triangle' of {known}, found '{clause.strip()}'")
    return wanted


if __name__ == "__main__":
    with suppress(KeyboardInterrupt):
        Expert().serve(sys.argv[1] if len(sys.argv) > 1 else "")
