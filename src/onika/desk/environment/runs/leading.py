"""A tool is led by a pad that somebody holds at a page (K07)."""

from onika.desk.environment.outcome.outcome import No, Procedure
from onika.desk.environment.outcome.runtime_refusal import simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.wire import act, live
from onika.words.reason import Reason


def push(model: Model, command: act.Push, _outside: Services) -> No | Procedure:
    """Pass it on; whether anybody is led by it is the runtime's to say, and how long it is believed."""
    if model.runtime.state != "linked":
        return No(Reason.of("desk.no_robot"))
    wish = live.Push(
        command.axes,
        command.is_held,
        command.button,
        command.scale,
        command.frame,
        command.subsystem,
        command.source,
    )
    return simply_done(model, wish)
