"""The console command `touch`: touches a part of a simulated world, such as a panic button (§4.5.2)."""

from msgspec import convert

from onika.desk.console.session import ConsoleSession, Faults
from onika.wire import live, request
from onika.words.reason import Reason

Words = tuple[str, ...]


def touch(session: ConsoleSession, words: Words) -> Faults:
    """Touch a part of a world; without part and value, say what there is to touch."""
    if len(words) == 1:
        return _list(session, words[0])
    if len(words) != 3:
        return session.no(Reason.of("console.touch_usage", words=" ".join(words)))
    world, part, value = words
    try:
        number = float(value)
    except ValueError:
        return session.no(Reason.of("console.number", word=value))
    faults = session.order(live.Touch(world, part, number))
    session.hear()
    return faults


def _list(session: ConsoleSession, world: str) -> Faults:
    answer = session.ask(live.Scene(world))
    if isinstance(answer, request.Refused):
        return session.no(Reason.of("console.world_refused", world=world, reason=answer.reason))
    parts = convert(answer.scene.get("parts", {}), dict[str, Reason]) if isinstance(answer, live.Scenery) else {}
    if parts:
        head = (Reason.of("console.head_part"), Reason.of("console.head_values"))
        session.show_table(head, sorted(parts.items()))
    else:
        session.say(Reason.of("console.no_parts"))
    return ()
