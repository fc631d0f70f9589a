"""Shows an audit trail as text: one line for each record, then whether its chain is whole (requirement X12)."""

from collections.abc import Iterator

from onika.files.trail import Record, TrailReading
from onika.words.reason import NOTHING, Reason


def lines(trail: TrailReading) -> Iterator[Reason]:
    """The records, oldest first."""
    for record in trail.records:
        yield sentence(record)


def sentence(record: Record) -> Reason:
    """When, who, from where, what, on what, and what came of it."""
    who = " ".join(_text(record, key) for key in ("who", "role") if record.get(key)) or "-"
    about = f" {_text(record, 'about')}" if record.get("about") else ""
    on = f" {_text(record, 'on')}" if record.get("on") else ""
    result = f": {_text(record, 'result')}" if record.get("result") else ""
    return Reason.of(
        "desk.record_line",
        at=_text(record, "at"),
        who=who,
        place=_address(record),
        what=f"{_text(record, 'what')}{on}{about}",
        code=_code(record),
        result=result,
    )


def verdict(trail: TrailReading) -> Reason:
    """Whether it is whole, and by which hash its end can be known again."""
    count = len(trail.records)
    if trail.faults:
        return Reason.of("desk.trail_broken", count=count, faults=len(trail.faults))
    if trail.begins:
        return Reason.of("desk.trail_goes_on", count=count, begins=trail.begins[:12], head=trail.head)
    return Reason.of("desk.trail_whole", count=count, head=trail.head)


def _address(record: Record) -> Reason:
    if record.get("address"):
        return Reason.of("desk.record_from", address=_text(record, "address"))
    return NOTHING


def _code(record: Record) -> Reason:
    """The code that came with it, by the beginnings of its digests."""
    code = record.get("code")
    if not isinstance(code, list):
        return NOTHING
    return Reason.of("desk.record_code", digests=" ".join(str(digest)[:12] for digest in code))


def _text(record: Record, key: str) -> str:
    """A piece of a record; nothing in it steers the terminal."""
    return "".join(letter if letter.isprintable() else "?" for letter in str(record.get(key, "")))
