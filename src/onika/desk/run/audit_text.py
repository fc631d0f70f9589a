"""Shows an audit trail as text: one line for each record, then whether its chain is whole (requirement X12)."""

from collections.abc import Iterator

from onika.files.trail import Record, Trail


def lines(trail: Trail) -> Iterator[str]:
    """The records, oldest first."""
    for record in trail.records:
        yield sentence(record)


def sentence(record: Record) -> str:
    """When, who, from where, what, on what, and what came of it."""
    who = " ".join(_text(record, key) for key in ("who", "role") if record.get(key)) or "-"
    place = f" from {_text(record, 'address')}" if record.get("address") else ""
    code = record.get("code")
    digests = f" code {' '.join(str(digest)[:12] for digest in code)}" if isinstance(code, list) else ""
    about = f" {_text(record, 'about')}" if record.get("about") else ""
    on = f" {_text(record, 'on')}" if record.get("on") else ""
    result = f": {_text(record, 'result')}" if record.get("result") else ""
    return f"{_text(record, 'at')}  {who}{place}  {_text(record, 'what')}{on}{about}{digests}{result}"


def verdict(trail: Trail) -> str:
    """Whether it is whole, and by which hash its end can be known again."""
    count = f"{len(trail.records)} records"
    if trail.faults:
        return f"{count}, NOT WHOLE: {len(trail.faults)} fault{'' if len(trail.faults) == 1 else 's'}"
    begins = f", going on from {trail.begins[:12]} in a file that is gone" if trail.begins else ""
    return f"{count}, whole{begins}; head {trail.head}"


def _text(record: Record, key: str) -> str:
    """A piece of a record; nothing in it steers the terminal."""
    return "".join(letter if letter.isprintable() else "?" for letter in str(record.get(key, "")))
