"""A sentence of a module, which travels as a reason whose key names the module and carries the sentence itself.

The key is `module:NAME:SENTENCE`. The translations of a module's sentences stand in a catalogue beside its code, so no
program needs one to understand the reason. A sentence without arguments has no gaps: it is taken as it is.
"""

from collections.abc import Mapping
from numbers import Integral, Real

from onika.words.reason import Argument, KeyedSentence, Reason, as_reason
from onika.words.sentence import fill, gaps

PREFIX = "module:"
"""How the key of a module's sentence begins."""

Sentence = Reason | str
"""What a module says: a sentence of its own with gaps, or a reason that it was given."""

_LARGEST_INTEGER = 1 << 63


def key_of(module: str, sentence: str) -> str:
    """The key of a module's sentence."""
    return f"{PREFIX}{module}:{sentence}"


def of_sentence(sentence: object, arguments: Mapping[str, object]) -> Reason:
    """The reason of a sentence whose module is not named yet; one that cannot be filled is taken as it is."""
    if isinstance(sentence, Reason | KeyedSentence):
        return as_reason(sentence)
    text = str(sentence)
    if not text:
        return Reason.plain("")
    try:
        values = {name: _argument(arguments[name]) for name in gaps(text)} if arguments else {}
        return Reason(key_of("", text), fill(text, values, "en") if arguments else text, values)
    except (KeyError, ValueError):
        return Reason(key_of("", text), text)


def of_module(reason: Reason, module: str) -> Reason:
    """The same in the name of a module, reasons within it too."""
    args = {name: _of_module(value, module) for name, value in reason.args.items()}
    unnamed = key_of("", "")
    key = key_of(module, reason.key.removeprefix(unnamed)) if reason.key.startswith(unnamed) else reason.key
    return Reason(key, reason.text, args)


def _of_module(value: Argument, module: str) -> Argument:
    if isinstance(value, tuple):
        return tuple(of_module(item, module) if isinstance(item, Reason) else item for item in value)
    if isinstance(value, Reason):
        return of_module(value, module)
    return value


def _argument(value: object) -> Argument:
    """A value that a module gives, as a plain one that can be sent."""
    if isinstance(value, Reason):
        return value
    if isinstance(value, list | tuple):
        return tuple(_one_argument(item) for item in value)
    return _one_argument(value)


def _one_argument(value: object) -> str | int | float | bool | Reason:
    if isinstance(value, Reason | bool):
        return value
    if isinstance(value, Integral):
        if -_LARGEST_INTEGER <= int(value) < _LARGEST_INTEGER:
            return int(value)
        return str(value)
    if isinstance(value, Real):
        return float(value)
    return str(value)
