"""Console commands about who may move the robots: stop, reset, take, release, hand, decline (law 27, §E.1)."""

from collections.abc import Iterator

from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.wire import holding, live, request
from onika.words.reason import Reason

Words = tuple[str, ...]


def stop(session: ConsoleSession, words: Words) -> Faults:
    """Every drive holds, at once, until `reset`."""
    cause = Reason.plain(" ".join(words)) or Reason.of("console.stopped_here")
    faults = session.order(request.Stop(cause))
    session.hear()
    return faults


def reset(session: ConsoleSession, words: Words) -> Faults:
    """After a stop: allow motion again; nothing moves by itself."""
    del words
    faults = session.order(live.Reset())
    session.hear()
    return faults


def take(session: ConsoleSession, words: Words) -> Faults:
    """Become the one who may change a subsystem."""
    return _hand(session, live.Take(words[0] if words else session.subsystem))


def release(session: ConsoleSession, words: Words) -> Faults:
    """Let another change a subsystem."""
    return _hand(session, live.Release(words[0] if words else session.subsystem))


def hand(session: ConsoleSession, words: Words) -> Faults:
    """Offer a subsystem to another session; without its name what was offered is withdrawn."""
    to, subsystem = (*words, "", "")[:2]
    return _hand(session, holding.Hand(subsystem or session.subsystem, to))


def decline(session: ConsoleSession, words: Words) -> Faults:
    """Say no to what is offered."""
    return _hand(session, holding.Decline(words[0] if words else session.subsystem))


def only_watch(session: ConsoleSession) -> Faults:
    """This console changes nothing any more."""
    faults = _hand(session, holding.OnlyWatch())
    if not faults:
        session.say(Reason.of("console.only_watches_now"), Tone.NOTE)
    return faults


def sessions(session: ConsoleSession, words: Words) -> Faults:
    """Who is there, and what each of them holds."""
    del words
    answer = session.ask(holding.Sessions())
    if not isinstance(answer, holding.Company):
        return session.no(Reason.of("console.sessions_refused", reason=_refusal(answer)))
    held: dict[str, list[str]] = {}
    for subsystem in session.look_again().subsystems:
        held.setdefault(subsystem.holder, []).append(subsystem.name)
    for other in answer.sessions:
        marks = tuple(_marks(other, held.get(other.name, []), is_own=other.name == answer.you))
        name = f"{other.name:<16} {other.role:<11}"
        session.say(Reason.of("console.session", name=name, marks=marks) if marks else Reason.plain(name.rstrip()))
    return ()


def _refusal(answer: request.Response) -> Reason:
    if isinstance(answer, request.Refused):
        return answer.reason
    return Reason.plain(str(answer))


def _marks(other: holding.SessionStanding, held: list[str], *, is_own: bool) -> Iterator[Reason]:
    """What is worth knowing of a session."""
    if is_own:
        yield Reason.of("console.this_console")
    if not other.is_here:
        yield Reason.of("console.away")
    if other.only_watches:
        yield Reason.of("console.only_watches")
    if held and other.lease_s:
        yield Reason.of("console.silent_at_most", seconds=other.lease_s)
    if held:
        yield Reason.of("console.holds", names=tuple(held))


def _hand(session: ConsoleSession, message: request.Request) -> Faults:
    faults = session.order(message)
    session.hear()
    return faults
