"""Messages as somebody may send them who does not know better, or means harm: made from what the structs say.

Three sources, mixed: a message made new from its struct, with values of the right types and names that exist; an honest
message with a few of its places changed; and bytes that are cut, flipped or glued. Everything hangs on the seed.
"""

from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import msgspec
from msgspec import inspect

_NUMBERS = (0, 1, -1, 2, 3, 7, 63, 255, 256, 65_536, 2**31 - 1, 2**31, -(2**31), 2**53, 2**63 - 1, -(2**63), 2**64 - 1)
_REALS = (0.0, -0.0, 1.0, -1.0, 0.5, 250.0, 1e-308, 5e-324, 1e308, -1e308, 1e-9, 1e6, 1e18, float("inf"), float("nan"))
TEXTS = (
    "", " ", "\0", "a\0b", "~", "~nobody", "/", "..", "../../etc/passwd", "*", "%s", "{}", "{x.y}", "\x1b[31mred",
    "\u202eabc",
    "a b", "é" * 40, "x" * 300, "y" * 5_000, "flow0/", "/X", "-1", "1e999", "NaN", "\ud7ff", "A" * 70_000, "\n", "x\ty",
)  # fmt: skip
_DEPTHS = (3, 40, 300)
_DEEP_BYTES = (50, 5_000, 200_000)
_DEEPEST = 20
_MANY = (0, 1, 2, 3, 200)


class MessageFuzz:
    """Draws messages of a union. `names` are texts that mean something where the messages go, by the field's name."""

    def __init__(
        self, union: Sequence[type], encode: Callable[[Any], bytes], seed: int, names: dict[str, Sequence[str]]
    ) -> None:
        self.random = Random(seed)
        self._kinds = [inspect.type_info(kind) for kind in union]
        self._encode = encode
        self._opening = encode([1])[:1]
        self.names = names
        self._all_names = [name for some in names.values() for name in some]

    def body(self, honest: Sequence[Any]) -> bytes:
        """The bytes of one message; `honest` are messages that would be taken."""
        draw = self.random.random()
        if honest and draw < 0.45:
            message = self._changed(msgspec.to_builtins(self.random.choice(honest), builtin_types=(bytes,)))
        else:
            message = self._struct(self.random.choice(self._kinds))
        body = self._encode(message)
        return self._garbled(body) if draw > 0.97 else body

    def with_text(self, kind: Any, name: str, text: str) -> dict[str, Any] | None:
        """A struct, right in every field, with this text in the field of this name; None where it takes no text."""
        made = {kind.tag_field: kind.tag} if kind.tag is not None else {}
        for field in kind.fields:
            if field.name == name:
                value = _holding(field.type, text)
                if value is None:
                    return None
                made[field.encode_name] = value
            elif field.required:
                made[field.encode_name] = self._value(field.type, field.name)
        return made

    def _struct(self, kind: Any) -> Any:
        """A struct as a map: each field right, wrong, or missing; once in a while one that nobody knows."""
        made: dict[str, Any] = {}
        if kind.tag is not None:
            made[kind.tag_field] = kind.tag
        for field in kind.fields:
            if not field.required and self.random.random() < 0.5:
                continue
            if self.random.random() < 0.01:
                continue
            made[field.encode_name] = self._value(field.type, field.name)
        if self.random.random() < 0.02:
            made["stranger"] = self._wild()
        return made

    def _value(self, kind: Any, name: str) -> Any:
        if self.random.random() < 0.03:
            return self._wild()
        match kind:
            case inspect.NoneType():
                return None
            case inspect.BoolType():
                return self.random.random() < 0.5
            case inspect.IntType():
                return self.random.choice(_NUMBERS)
            case inspect.FloatType():
                return self.random.choice(_REALS)
            case inspect.StrType():
                return self._text(name)
            case inspect.BytesType():
                return self.random.randbytes(self.random.choice((0, 1, 20)))
            case inspect.LiteralType():
                return self.random.choice(kind.values)
            case inspect.UnionType():
                return self._value(self.random.choice(kind.types), name)
            case inspect.StructType():
                return self._struct(kind)
            case inspect.TupleType():
                return [self._value(item, name) for item in kind.item_types]
            case inspect.VarTupleType() | inspect.ListType():
                count = self.random.choice((0, 1, 1, 2, 3))
                return [self._value(kind.item_type, name) for _ in range(count)]
            case inspect.DictType():
                return {self._text(name): self._value(kind.value_type, name) for _ in range(self.random.randrange(3))}
        return self._wild()

    def _text(self, name: str) -> str:
        """Mostly a name that exists: of that field, else of any."""
        draw = self.random.random()
        values = self.names.get(name)
        if values and draw < 0.7:
            return self.random.choice(values)
        if self._all_names and draw < 0.85:
            return self.random.choice(self._all_names)
        return self.random.choice(TEXTS)

    def _wild(self) -> Any:
        """A value of any type."""
        choice = self.random.randrange(8)
        if choice == 0:
            return self._deep(self.random.choice(_DEPTHS))
        if choice == 1:
            return [self.random.choice(_NUMBERS)] * self.random.choice(_MANY)
        if choice == 2:
            return {self.random.choice(TEXTS): self.random.choice(_REALS)}
        return self.random.choice((None, True, *_NUMBERS, *_REALS, *TEXTS))

    def _deep(self, depth: int) -> Any:
        nest: Any = 1
        for _ in range(depth):
            nest = [nest] if self.random.random() < 0.7 else {"type": nest}
        return nest

    def _changed(self, message: Any) -> Any:
        """One to three places of an honest message are different."""
        for _ in range(self.random.choice((1, 1, 2, 3))):
            places = list(_places(message))
            if not places:
                break
            holder, key = self.random.choice(places)
            self._change(holder, key)
        return message

    def _change(self, holder: Any, key: Any) -> None:
        draw = self.random.random()
        if draw < 0.12 and isinstance(holder, dict):
            del holder[key]
        elif draw < 0.12:
            holder.append(holder[key])
        elif draw < 0.2 and isinstance(holder, list):
            del holder[key]
        else:
            holder[key] = self._other(holder[key], str(key))

    def _other(self, value: Any, name: str) -> Any:
        """Another value, mostly of the same type."""
        if self.random.random() < 0.15:
            return self._wild()
        if isinstance(value, str):
            cut = value[: self.random.randrange(len(value) + 1)]
            return self.random.choice((self._text(name), self._text(name), cut, value + self.random.choice(TEXTS)))
        if isinstance(value, bool):
            return not value
        if isinstance(value, int):
            return self.random.choice((min(value + 1, _NUMBERS[-1]), max(value - 1, -(2**63)), *_NUMBERS))
        if isinstance(value, float):
            return self.random.choice((value * 2, -value, *_REALS))
        if isinstance(value, list):
            return self.random.choice(([], value + value, value[::-1]))
        return self._wild()

    def _garbled(self, body: bytes) -> bytes:
        choice = self.random.randrange(5)
        place = self.random.randrange(len(body) + 1)
        if choice == 0:
            return body[:place]
        if choice == 1:
            return body[:place] + self.random.randbytes(3) + body[place:]
        if choice == 2:
            return body + body
        if choice == 3:
            return body[:place] + self._opening * self.random.choice(_DEEP_BYTES)
        flipped = bytearray(body)
        for _ in range(3):
            flipped[self.random.randrange(len(flipped))] = self.random.randrange(256)
        return bytes(flipped)


def _places(value: Any, depth: int = 0) -> Any:
    """Every place of a nest of maps and lists, as what holds it and its key or number there."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, held in list(items):
        yield value, key
        if depth < _DEEPEST:
            yield from _places(held, depth + 1)


def _holding(kind: Any, text: str) -> Any:
    """A value of this type with the text in it; None where there is no place for one."""
    match kind:
        case inspect.StrType():
            return text
        case inspect.UnionType():
            return next((value for each in kind.types if (value := _holding(each, text)) is not None), None)
        case inspect.VarTupleType() | inspect.ListType():
            held = _holding(kind.item_type, text)
            return None if held is None else [held]
        case inspect.TupleType():
            held = [_holding(each, text) for each in kind.item_types]
            return None if None in held else held
        case inspect.DictType():
            return {text: 0}
    return None
