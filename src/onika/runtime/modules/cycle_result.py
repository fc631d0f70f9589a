"""The result of a cycle taken as a signal: no module is trusted to return a valid one."""

from operator import index

from onika.model.signal import Signal, SignalKind
from onika.words.reason import Reason


def signal_of(returned: object, *, is_trigger: bool) -> Signal:
    """It as a signal of plain values; raises TypeError where it is none, or none of a task like this."""
    if not isinstance(returned, Signal):
        raise TypeError(Reason.of("runtime.no_signal", returned=repr(returned)))
    if returned.kind is SignalKind.FINISH and not is_trigger:
        raise TypeError(Reason.of("runtime.finish_of_no_trigger"))
    if type(returned.flow) is int and type(returned.loop) is bool and not returned.text and not returned.number:
        return returned
    flow, number = index(returned.flow), index(returned.number)
    text = returned.text if isinstance(returned.text, Reason) else str(returned.text)
    return Signal(returned.kind, flow, bool(returned.loop), number, text)
