"""The console command `jumps`: lists how far hardware inputs stepped when their source changed (requirement X04)."""

from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.run import text_table
from onika.wire import event
from onika.wire.figures import VariableSteps
from onika.words.reason import Reason

Words = tuple[str, ...]


def jumps(session: ConsoleSession, words: Words) -> Faults:
    """The last step of each variable of living subsystems, the largest of the last run of others."""
    steps = [step for _, step in sorted(session.steps.items()) if not words or step.subsystem == words[0]]
    if not steps:
        session.say(Reason.of("console.no_step"), Tone.DIM)
        return ()
    session.show(text_table.lines(("variable", "step", "of", "share/%", "unit", "at/s", "became"), map(_row, steps)))
    return ()


def _row(step: event.Stepped | VariableSteps) -> tuple[str, ...]:
    share = f"{step.step / step.limit * 100:.0f}" if step.limit else "-"
    limit = f"{step.limit:.4g}" if step.limit else "-"
    name = f"{step.subsystem}/{step.variable}[{step.index}]"
    return name, f"{step.step:.4g}", limit, share, step.unit, f"{step.at_s:.2f}", _became(step)


def _became(step: event.Stepped | VariableSteps) -> str:
    if isinstance(step, event.Stepped):
        if not step.is_too_far:
            return "passed on"
        if step.cycles:
            return f"blended over {step.cycles} cycles"
        return "refused"
    words = [f"blended {step.blended} of {step.count} times"] * bool(step.blended)
    words += [f"refused {step.refused} of {step.count} times"] * bool(step.refused)
    return ", ".join(words) or f"passed on, the largest of {step.count}"
