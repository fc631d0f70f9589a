"""Where a flow is, as its events say: one reducer under scripts that wait, runs that are shown, and reviews (E11)."""

from dataclasses import dataclass, replace

from onika.wire import event, steer

WAITS = ("waiting", "joining")
"""States in which a flow waits for another one."""


@dataclass(frozen=True, slots=True)
class FlowStatus:
    """Where one flow is; `action` is -1 before the first."""

    state: str = "ready"
    action: int = -1
    name: str = ""
    """Of the action that began last."""
    is_acting: bool = False
    """Whether that action is carried out, and neither done nor left."""
    tag: str = ""
    waits_for: tuple[str, ...] = ()
    waits_since_s: float = 0.0

    def began(self, began: event.Began) -> "FlowStatus":
        """An action has begun."""
        return replace(self, action=began.index, name=began.action, is_acting=True)

    def done(self) -> "FlowStatus":
        """Its action is done."""
        return replace(self, is_acting=False)

    def moved(self, moved: event.Moved) -> "FlowStatus":
        """It has come into another state, or something more is known of the one it is in."""
        since_s = self.waits_since_s if self.state == moved.state else moved.at_s
        return replace(
            self,
            state=moved.state,
            action=moved.action,
            tag=moved.tag,
            waits_for=moved.waits_for,
            waits_since_s=since_s if moved.state in WAITS else 0.0,
        )

    def placed(self, position: steer.Position) -> "FlowStatus":
        """The runtime has said where it is, which counts more than what was heard."""
        return replace(
            self, state=position.state, action=position.action, tag=position.tag, waits_for=position.waits_for
        )
