"""Console commands about the network channel: open, listen, network, close (requirement A16, §E.1)."""

from collections.abc import Iterator

from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.link.address import PORT
from onika.link.caller import Role
from onika.wire import holding, request
from onika.words.reason import Reason

Words = tuple[str, ...]
HERE = f"127.0.0.1:{PORT}"
"""Where a runtime is opened if nothing is said: only programs of this machine come there."""
_FILES = ("cert", "key", "users")
_ROLES = tuple(role.word for role in Role)


def open_channel(session: ConsoleSession, words: Words) -> Faults:
    """Say where others reach this runtime, or open it to them; only its owner may."""
    addresses = session.look_again().addresses
    if addresses and (not words or words[0] in addresses):
        for address in addresses:
            session.say(Reason.of("console.reached_at", address=address), Tone.GOOD)
        return ()
    if addresses:
        reason = Reason.of("console.listens_elsewhere", addresses=" ".join(addresses))
        return session.no(reason, Reason.of("console.close_first"))
    message = _listen(words)
    if isinstance(message, Reason):
        return session.no(message)
    answer = session.ask(message)
    if not isinstance(answer, holding.Listening):
        return session.no(Reason.of("console.runtime_refused", reason=_refusal(answer)))
    session.look_again()
    for line in _told(answer):
        session.say(line, Tone.GOOD)
    return ()


def close_channel(session: ConsoleSession, words: Words) -> Faults:
    """Let nobody in any more; who is inside is told good-bye."""
    del words
    faults = session.order(holding.StopListening())
    if not faults:
        session.look_again()
        session.say(Reason.of("console.closed_now"), Tone.GOOD)
    return faults


def _listen(words: Words) -> holding.Listen | Reason:
    """What is asked of the runtime; or what was expected."""
    place, files, role = HERE, {}, "viewer"
    for number, word in enumerate(words):
        name, equals, value = word.partition("=")
        if equals and name in _FILES and value:
            files[name] = value
        elif word in _ROLES:
            role = word
        elif number == 0 and not equals:
            place = word
        else:
            return Reason.of("console.listen_words", roles=_ROLES, word=word)
    return holding.Listen(place, role, files.get("cert", ""), files.get("key", ""), files.get("users", ""))


def _told(listening: holding.Listening) -> Iterator[Reason]:
    for address in listening.addresses:
        yield Reason.of("console.reached_at", address=address)
    if listening.token_at:
        yield Reason.of("console.own_token", path=listening.token_at)
    if listening.token:
        yield Reason.of("console.token_once", role=listening.role, token=listening.token)


def _refusal(answer: request.Response) -> Reason:
    if isinstance(answer, request.Refused):
        return answer.reason
    return Reason.plain(str(answer))
