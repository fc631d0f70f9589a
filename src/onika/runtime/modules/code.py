"""Loads a module's file: source text to class, anew for every running task, so that nothing is shared (law 14)."""

import sys
import traceback
import types

from onika.runtime.error import AskAgain, ModuleError, RaisedElsewhere
from onika.runtime.modules.module import Module
from onika.words.fault import Fault, Place
from onika.words.module_sentence import of_module
from onika.words.reason import KeyedSentence, Reason, as_reason, reason_of


def compiled(source: str, path: str, module: str) -> types.CodeType | Fault:
    """A module's source compiled, which is most of the time that loading takes, or the fault with its place."""
    instead = Reason.of("runtime.module_not_loaded", module=module)
    try:
        return compile(source, path, "exec", dont_inherit=True)
    except SyntaxError as wrong:
        return Fault(
            Place(path, wrong.lineno or 0),
            Reason.of("runtime.not_python", msg=wrong.msg, strip=(wrong.text or "").strip()),
            instead,
        )
    except ValueError as wrong:
        return Fault(Place(path), Reason.of("runtime.not_python_why", why=reason_of(wrong)), instead)


def load(source: str, path: str, module: str, code: types.CodeType | Fault | None = None) -> type[Module] | Fault:
    """Execute a module's source and return its one subclass of Module, or the fault with its place.

    `code` is the source compiled, where that was done before.
    """
    code = code or compiled(source, path, module)
    if isinstance(code, Fault):
        return code
    instead = Reason.of("runtime.module_not_loaded", module=module)
    namespace = types.ModuleType(f"onika_task_{module}")
    namespace.__file__ = path
    sys.modules[namespace.__name__] = namespace  # dataclasses look their own file up while they are made
    try:
        exec(code, namespace.__dict__)  # noqa: S102 - running modules is what a runtime is for; trust is decided before
    except BaseException as wrong:  # one that exits is as wrong as any other
        return Fault(
            Place(path, line_in(path, wrong)), Reason.of("runtime.unimportable", given=raised(wrong, module)), instead
        )
    finally:
        sys.modules.pop(namespace.__name__, None)
    classes = [
        value
        for value in vars(namespace).values()
        if isinstance(value, type) and issubclass(value, Module) and value.__module__ == namespace.__name__
    ]
    if len(classes) != 1:
        if not classes:
            return Fault(Place(path), Reason.of("runtime.no_module_class"), instead)
        names = tuple(cls.__name__ for cls in classes)
        return Fault(Place(path), Reason.of("runtime.one_module_class", names=names), instead)
    return classes[0]


def line_in(path: str, wrong: BaseException) -> int:
    """The last line of a file that an exception passed through; 0 if it did not."""
    lines = [frame.lineno or 0 for frame in traceback.extract_tb(wrong.__traceback__) if frame.filename == path]
    return lines[-1] if lines else 0


def where(path: str, wrong: BaseException) -> tuple[str, int, str]:
    """File and line in which a module's code raised, and the traceback from there on."""
    if isinstance(wrong, RaisedElsewhere | ModuleError | AskAgain) and wrong.raised_at is not None:
        return wrong.raised_at
    frames = traceback.extract_tb(wrong.__traceback__)
    own = [index for index, frame in enumerate(frames) if frame.filename == path]
    if not own:
        return path, 0, traceback_text(wrong)
    lines = traceback.format_list(frames[own[0] :])
    return path, frames[own[-1]].lineno or 0, showable("".join([*lines, traceback_text(wrong)]), 10_000)


def traceback_text(wrong: BaseException) -> str:
    """An exception as a text that can be shown."""
    try:
        text = str(wrong)
    except BaseException:  # whose own text raises, or exits
        text = ""
    return showable(f"{type(wrong).__name__}: {text}" if text else type(wrong).__name__)


def raised(wrong: BaseException, module: str) -> Reason:
    """An exception of a module as a reason that can be shown: its kind and what it says."""
    sentence = wrong.args[0] if wrong.args else None
    if isinstance(wrong, RaisedElsewhere) and isinstance(sentence, Reason):
        return sayable(sentence, module)
    if not isinstance(sentence, Reason | KeyedSentence) or not sentence:
        return Reason.plain(traceback_text(wrong))
    return Reason.of("runtime.raised", kind=type(wrong).__name__, why=sayable(as_reason(sentence), module))


def sayable(text: Reason, module: str) -> Reason:
    """What a module says, in its name and as it can be shown; what cannot be shown as it is has no translation."""
    english = showable(str(text))
    if not isinstance(text, Reason) or not _is_showable(text):
        return Reason.plain(english)
    return of_module(text, module)


def _is_showable(reason: Reason) -> bool:
    values = [item for value in reason.args.values() for item in (value if isinstance(value, tuple) else (value,))]
    texts = [value for value in values if isinstance(value, str)]
    reasons = [value for value in values if isinstance(value, Reason)]
    return all(showable(text) == text for text in (reason.key, reason.text, *texts)) and all(map(_is_showable, reasons))


def showable(text: str, longest: int = 1000) -> str:
    """A module's text without control characters and unpaired surrogates, and of a length that people read."""
    clean = "".join(letter if letter.isprintable() or letter == "\n" else "\ufffd" for letter in text[: longest + 1])
    if len(text) <= longest:
        return clean
    return clean[:longest] + "…"
