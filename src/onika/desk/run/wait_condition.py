"""A wait condition: what a script waits for, such as seconds, the beginning of an action, or a paused flow."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class WaitCondition:
    """`seconds` later, or that an action has `began` or is `done`, or that a flow is in a state.

    The states are `paused`, `waiting`, `stopped` and `done` (without an action). Without a flow: any flow that waits
    or has stopped, every flow paused or done.
    """

    kind: str
    subsystem: str = ""
    action: int | None = None
    seconds: float = 0.0

    def __str__(self) -> str:
        if self.kind == "seconds":
            return f"{self.seconds:g} s"
        if self.action is not None:
            how = "has begun" if self.kind == "began" else "is done"
            return f"action {self.action + 1} of {self.subsystem} {how}"
        quantity = self.subsystem or ("every flow" if self.kind in ("paused", "done") else "a flow")
        return f"{quantity} {_VERB[self.kind]}"


_VERB = {"paused": "is paused", "waiting": "waits", "stopped": "has stopped", "done": "is done"}
