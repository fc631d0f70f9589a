"""The console command `jumps`: lists how far hardware inputs stepped when their source changed (requirement X04)."""

from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.run.text_table import Cell
from onika.wire import event
from onika.wire.figures import VariableSteps
from onika.words.reason import NOTHING, Reason

Words = tuple[str, ...]
_HEAD = (
    Reason.of("console.head_variable"),
    Reason.of("console.head_step"),
    Reason.of("console.head_of"),
    Reason.of("console.head_share"),
    Reason.of("console.head_unit"),
    Reason.of("console.head_at"),
    Reason.of("console.head_became"),
)


def jumps(session: ConsoleSession, words: Words) -> Faults:
    """The last step of each variable of living subsystems, the largest of the last run of others."""
    steps = [step for _, step in sorted(session.steps.items()) if not words or step.subsystem == words[0]]
    if not steps:
        session.say(Reason.of("console.no_step"), Tone.DIM)
        return ()
    session.show_table(_HEAD, map(_row, steps))
    return ()


def _row(step: event.Stepped | VariableSteps) -> tuple[Cell, ...]:
    share = f"{step.step / step.limit * 100:.0f}" if step.limit else "-"
    limit = f"{step.limit:.4g}" if step.limit else "-"
    name = f"{step.subsystem}/{step.variable}[{step.index}]"
    return name, f"{step.step:.4g}", limit, share, step.unit, f"{step.at_s:.2f}", _became(step)


def _became(step: event.Stepped | VariableSteps) -> Reason:
    if isinstance(step, event.Stepped):
        if not step.is_too_far:
            return Reason.of("console.passed_on")
        if step.cycles:
            return Reason.of("console.blended_over", cycles=step.cycles)
        return Reason.of("console.step_refused")
    blended = Reason.of("console.blended_times", blended=step.blended, count=step.count) if step.blended else NOTHING
    refused = Reason.of("console.refused_times", refused=step.refused, count=step.count) if step.refused else NOTHING
    parts = tuple(part for part in (blended, refused) if part)
    if parts:
        return Reason.of("console.several", parts=parts)
    return Reason.of("console.passed_on_largest", count=step.count)
