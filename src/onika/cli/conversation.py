"""The conversation at a console: it carries out lines and shows what happens meanwhile (A16)."""

from collections.abc import Callable, Iterator
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from onika.cli.language import say
from onika.desk.console.display import ConsoleDisplay, Tone
from onika.desk.console.session import ConsoleSession, Faults, typed_fault
from onika.desk.run.interruption import Interruption
from onika.words.fault import Place
from onika.words.reason import Reason

if TYPE_CHECKING:
    from onika.desk.console.console import Console

_LOOK_S = 0.05
_SERVED_S = 0.5
_TURN_S = 0.1


class LineDesk(ConsoleDisplay, Protocol):
    """Where lines come from and go to."""

    is_person: bool

    def line(self, prompt: str, timeout_s: float) -> str | None:
        """The next line, None while there is none yet; raises EOFError at the end of the input."""
        ...

    def drop(self) -> None:
        """Forget what was typed of this line."""
        ...


def next_line(desk: LineDesk, prompt: str) -> str | None:
    """The next line of a desk; None at the end of the input.

    It is waited for in short turns, so that a Ctrl-C just before a wait is not missed.
    """
    try:
        while (line := desk.line(prompt, _TURN_S)) is None:
            pass
    except EOFError:
        return None
    return line


def converse(console: "Console", desk: LineDesk, script: Path | None) -> int:
    """Carry out the script, then the lines of the desk, to their end; the exit code.

    A person goes on after a line that failed. Lines from a file or a pipe are a script: the first that fails ends them.
    """
    if script is not None:
        faults = _guarded(console.session, lambda: console.run_script(script))
        _show(desk, faults, typed=False)
        if faults and not desk.is_person:
            return 1
    console.session.in_script = not desk.is_person
    numbers = count(1)
    while True:
        with Interruption() as interruption:  # beneath those of single lines, so that none is lost between them
            code = _talk(console, desk, interruption, numbers)
        if code is not None:
            return code


def run_batch(console: "Console", desk: ConsoleDisplay, script: Path) -> int:
    """Carry out a script and nothing else; the exit code."""
    faults = _guarded(console.session, lambda: console.run_script(script) or console.finish())
    _show(desk, faults, typed=False)
    return 1 if faults else 0


def serve(console: "Console") -> int:
    """Show what happens, until Ctrl-C, which stops everything; the exit code."""
    with Interruption() as interruption:
        while not interruption.is_new():
            console.session.hear(_SERVED_S)
        console.session.interrupt()
    return 0


def _talk(console: "Console", desk: LineDesk, interruption: Interruption, numbers: Iterator[int]) -> int | None:
    """Lines up to the end, and the exit code; None after a Ctrl-C, so that only two in a row end everything."""
    while not console.is_over:
        console.session.hear()
        if interruption.is_new():
            _interrupted(console.session, desk)
            return None
        try:
            line = desk.line(_prompt(console.session), _LOOK_S)
        except EOFError:
            return _end(console, desk)
        if line is None:
            continue
        place = None if desk.is_person else Place("stdin", next(numbers))
        faults = _carry_out(console, line, place)
        _show(desk, faults, typed=desk.is_person)
        if faults and not desk.is_person:
            return 1
    return 0


def _end(console: "Console", desk: LineDesk) -> int:
    """After the last line; who is no person waits for the outcome of a run."""
    console.session.hear()
    faults = () if desk.is_person else _guarded(console.session, console.finish)
    _show(desk, faults, typed=False)
    return 1 if faults else 0


def _carry_out(console: "Console", line: str, place: Place | None) -> Faults:
    if place is None:
        return _guarded(console.session, lambda: console.answer(line))
    return _guarded(console.session, lambda: console.carry_out(line, place))


def _guarded(session: ConsoleSession, act: Callable[[], Faults]) -> Faults:
    """Do it; Ctrl-C meanwhile stops everything, the second one is a KeyboardInterrupt."""
    with Interruption() as interruption:
        session.is_interrupted = interruption.is_new
        faults = act()
        if interruption.is_new():
            return (*faults, *session.interrupt())
        return faults


def _interrupted(session: ConsoleSession, desk: LineDesk) -> None:
    """Ctrl-C at the prompt: stop where something may move, else only forget what was typed."""
    desk.drop()
    moves = session.running or any(
        task.state == "ON" for subsystem in session.standing().subsystems for task in subsystem.tasks
    )
    if moves:
        session.interrupt()
    else:
        desk.say(Reason.of("cli.nothing_moves"), Tone.DIM)


def _prompt(session: ConsoleSession) -> str:
    if session.questions:
        subsystem, name = next(iter(session.questions))
        if subsystem == session.subsystem:
            return f"{name}? "
        return f"{subsystem}/{name}? "
    if session.is_stopped:
        return f"{say(Reason.of('console.prompt_stopped', subsystem=session.subsystem))}> "
    return f"{session.subsystem}> "


def _show(desk: ConsoleDisplay, faults: Faults, typed: bool) -> None:
    for fault in faults:
        is_in_typed_line = typed and fault.place == Place("line")
        desk.say(typed_fault(fault) if is_in_typed_line else fault.sentence, Tone.FAULT)
