"""A wait condition: what a script waits for, such as seconds, the beginning of an action, or a paused flow."""

from dataclasses import dataclass

from onika.words.reason import Reason


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

    @property
    def sentence(self) -> Reason:
        """What is waited for, in words."""
        if self.kind == "seconds":
            return Reason.of("desk.moment_seconds", seconds=self.seconds)
        if self.action is not None and self.kind == "began":
            return Reason.of("desk.moment_began", number=self.action + 1, flow=self.subsystem)
        if self.action is not None:
            return Reason.of("desk.moment_action_done", number=self.action + 1, flow=self.subsystem)
        flow = Reason.plain(self.subsystem)
        if not self.subsystem and self.kind in ("paused", "done"):
            flow = Reason.of("desk.moment_every_flow")
        elif not self.subsystem:
            flow = Reason.of("desk.moment_a_flow")
        return Reason.of(_MOMENTS[self.kind], flow=flow)


_MOMENTS = {
    "paused": "desk.moment_paused",
    "waiting": "desk.moment_waiting",
    "stopped": "desk.moment_stopped",
    "done": "desk.moment_done",
}
