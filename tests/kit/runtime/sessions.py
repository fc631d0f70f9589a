"""What sessions do to a runtime in virtual time: they come, fall silent, and leave."""

from kit.runtime.live_edits import LiveEdits
from onika.wire import holding

SECOND = 1_000_000_000


def there(hand: LiveEdits, *sessions: str) -> None:
    """They are known by name from now on."""
    for session in sessions:
        hand.asker.ask(holding.Sessions(), session)


def silent(hand: LiveEdits, session: str, seconds: float) -> None:
    """It has said nothing for so long, and speaks again afterwards."""
    hand.asker.server.silent[session] = round(seconds * SECOND)
    hand.asker.program.serve()
    hand.work()
    hand.asker.server.silent[session] = 0


def leave(hand: LiveEdits, session: str) -> None:
    """Its connection is no more."""
    hand.asker.server.gone.append(session)
    hand.asker.program.serve()
    hand.work()
