"""The console command `what-if`: what would follow from a fault that could come now (requirement X24)."""

from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.run.text_table import Cell
from onika.wire import request
from onika.wire.foresight import Effect, Foreseen, Foresight, WhatIf
from onika.words.reason import Reason

Words = tuple[str, ...]
_QUESTIONS = (Reason.of("console.head_fault"), Reason.of("console.head_whom"), Reason.of("console.head_question"))
_EFFECTS = (
    Reason.of("console.head_within"),
    Reason.of("console.head_changes"),
    Reason.of("console.head_whom"),
    Reason.of("console.head_before"),
    Reason.of("console.head_after"),
)
_NOBODY = "-"


def what_if(session: ConsoleSession, words: Words) -> Faults:
    """Say what follows from a fault; without one, which can be asked about. Nothing is touched."""
    fault, subject = (*words, "", "")[:2]
    answer = session.ask(WhatIf(fault, subject))
    if isinstance(answer, request.Refused):
        return session.no(answer.reason)
    foresights = answer.foresights if isinstance(answer, Foreseen) else ()
    if not words:
        session.show_table(_QUESTIONS, map(_asked, foresights))
        return ()
    for foresight in foresights:
        _tell(session, foresight)
    return ()


def _asked(foresight: Foresight) -> tuple[Cell, ...]:
    return foresight.fault, foresight.subject or _NOBODY, foresight.question


def _tell(session: ConsoleSession, foresight: Foresight) -> None:
    session.say(foresight.question, Tone.HEAD)
    if foresight.answer is not None:
        session.say(foresight.answer)
    if foresight.effects:
        session.show_table(_EFFECTS, map(_changes, foresight.effects))
    for deed in foresight.to_do:
        session.say(Reason.of("console.to_do", what=deed))
    for note in foresight.notes:
        session.say(note, Tone.DIM)


def _changes(effect: Effect) -> tuple[Cell, ...]:
    within_ms = f"{effect.within_ms:.0f}"
    return within_ms, effect.kind, effect.subject or _NOBODY, effect.before or _NOBODY, effect.after or _NOBODY
