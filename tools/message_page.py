"""The page of messages: what environment and runtime say to each other, drawn from the structs of `wire/`."""

import ast
from collections.abc import Iterable, Iterator
from inspect import cleandoc
from pathlib import Path
from types import ModuleType
from typing import get_args

import msgspec

from onika.ring import displacement
from onika.wire import (
    booking,
    event,
    figures,
    foresight,
    holding,
    live,
    plan,
    question,
    reading,
    rendezvous_link,
    request,
    runtime_standing,
    samples,
    sheet,
    steer,
    world_source,
)

_HEAD = """\
# Messages

What travels in requests, responses, signals and readings of [the protocol](protocol.md): MessagePack maps, whose key
`type` is the title of the message; the other keys are its fields. Maps that are only parts of others have no `type`,
but for the instructions of a flow's program (`Instruction` is one of `Do` to `Halt`). Unknown keys are ignored; a
missing one takes its default, or is an error where it has none.

`tuple[...]` and `list[...]` are arrays, `dict[...]` a map, `X | None` may be nil, `Any` is any value. `Index` is an
`int` that is not negative, `Site` one up to 255, `Span` one of nanoseconds up to ten seconds; a `float` may come as a
whole number. `Reason` and `NOTHING`, the empty one, are those of [reasons](protocol.md#reasons). States of tasks and
flows are the words of [lifecycles](lifecycles.md).
This page is drawn from the code by `python tools/generate.py`.
"""


_ROOMS = (
    plan,
    world_source,
    request,
    live,
    runtime_standing,
    displacement,
    steer,
    holding,
    booking,
    rendezvous_link,
    question,
    event.explanation,
    figures,
    sheet,
    foresight,
    samples,
)
"""Where the parts of messages are defined."""


def page() -> str:
    """The whole page."""
    apart = {
        "Requests about subsystems, by hand": get_args(live.LiveRequest),
        "Requests about who holds what": get_args(holding.HoldingRequest),
        "Requests about bookings": get_args(booking.BookingRequest),
        "Requests about flows of several runtimes": get_args(rendezvous_link.RendezvousRequest),
    }
    of_others = {one for structs in apart.values() for one in structs}
    asked = [one for one in get_args(request.Request) if one not in of_others]
    answered = get_args(request.Response)
    parts = [one for module in _ROOMS for one in _structs(module)]
    told = {*get_args(request.Request), *answered, *get_args(event.Event), *get_args(reading.Reading)}
    return "\n".join(
        (
            _HEAD,
            _section("Requests about applications and the runtime", asked),
            *(_section(title, structs) for title, structs in apart.items()),
            _section("Responses", answered),
            _section("Events, which travel as signals", get_args(event.Event)),
            _section("Readings", get_args(reading.Reading)),
            _section("Parts of others", [one for one in parts if one not in told]),
        )
    )


def _structs(module: ModuleType) -> list[type]:
    """The structs that are defined in a file, in its order."""
    named = ast.parse(Path(module.__file__ or "").read_text(encoding="utf-8"))
    found = [getattr(module, one.name) for one in named.body if isinstance(one, ast.ClassDef)]
    return [one for one in found if issubclass(one, msgspec.Struct)]


def _section(title: str, structs: Iterable[type]) -> str:
    return "\n".join((f"## {title}\n", *map(_message, structs)))


def _message(struct: type) -> str:
    doc = cleandoc(struct.__doc__ or "")
    lines = [f"### {struct.__name__}\n", doc, ""]
    fields = list(_fields(struct))
    if fields:
        lines += ["| field | type | default | |", "|---|---|---|---|"]
        lines += [f"| `{name}` | `{kind}` | {default} | {note} |" for name, kind, default, note in fields]
        lines.append("")
    return "\n".join(lines)


def _fields(struct: type) -> Iterator[tuple[str, str, str, str]]:
    """Name, type, default and the words that stand behind each field in the source."""
    file = Path(__import__(struct.__module__, fromlist=["x"]).__file__ or "")
    body = next(
        one.body
        for one in ast.parse(file.read_text(encoding="utf-8")).body
        if isinstance(one, ast.ClassDef) and one.name == struct.__name__
    )
    for place, one in enumerate(body):
        if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name):
            kind = ast.unparse(one.annotation).replace("'", "").replace("|", "\\|")
            default = "" if one.value is None else f"`{ast.unparse(one.value)}`".replace("()", "[]").replace("'", '"')
            behind = body[place + 1] if place + 1 < len(body) else None
            yield one.target.id, kind, default, _words(behind).replace("|", "\\|")


def _words(behind: ast.stmt | None) -> str:
    if isinstance(behind, ast.Expr) and isinstance(behind.value, ast.Constant):
        return " ".join(str(behind.value.value).split())
    return ""
