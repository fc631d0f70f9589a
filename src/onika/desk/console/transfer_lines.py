"""`jumps`: how far inputs of hardware stepped where what drives them was exchanged (X04)."""

from onika.desk.console.display import Tone
from onika.desk.console.session import Faults, Session
from onika.desk.run import text_table
from onika.wire import event
from onika.wire.figures import VariableSteps

Words = tuple[str, ...]


def jumps(session: Session, words: Words) -> Faults:
    """The last step of each variable of living subsystems, the largest of the last run of others."""
    told = [one for _, one in sorted(session.steps.items()) if not words or one.subsystem == words[0]]
    if not told:
        session.say("no step was told yet: nothing that drives hardware was exchanged while it was driven", Tone.DIM)
        return ()
    session.show(text_table.lines(("variable", "step", "of", "share/%", "unit", "at/s", "became"), map(_row, told)))
    return ()


def _row(one: event.Stepped | VariableSteps) -> tuple[str, ...]:
    share = f"{one.step / one.limit * 100:.0f}" if one.limit else "-"
    limit = f"{one.limit:.4g}" if one.limit else "-"
    name = f"{one.subsystem}/{one.variable}[{one.index}]"
    return name, f"{one.step:.4g}", limit, share, one.unit, f"{one.at_s:.2f}", _became(one)


def _became(one: event.Stepped | VariableSteps) -> str:
    if isinstance(one, event.Stepped):
        if not one.is_too_far:
            return "passed on"
        return f"blended over {one.cycles} cycles" if one.cycles else "refused"
    words = [f"blended {one.blended} of {one.count} times"] * bool(one.blended)
    words += [f"refused {one.refused} of {one.count} times"] * bool(one.refused)
    return ", ".join(words) or f"passed on, the largest of {one.count}"
