"""What a runtime that was started by ssh says of itself on its output, in one line, so that it can be reached (A15)."""

from msgspec import DecodeError, Struct, ValidationError, json


class HandOver(Struct, frozen=True, forbid_unknown_fields=False, tag_field="onika", tag="hand-over"):
    """Where it listens on its own machine, and with which token.

    port      of 127.0.0.1
    token     that of its user on that machine
    process   its process id there
    is_new    False: it was there already, and stays
    """

    port: int
    token: str
    process: int
    is_new: bool = True


def line_of(hand_over: HandOver) -> str:
    """The line."""
    return json.encode(hand_over).decode()


def hand_over_in(line: str) -> HandOver | None:
    """What a line says; None: it is another one, such as a greeting of that machine."""
    try:
        hand_over = json.decode(line, type=HandOver)
    except (DecodeError, ValidationError):
        return None
    return hand_over if 0 < hand_over.port < 65536 else None
