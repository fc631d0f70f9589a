"""Kinds of words that several commands take: each function makes a value of one, or raises ArgumentTypeError."""

import argparse
from pathlib import Path

from onika.cli.language import say
from onika.link.starting.runtime_address import address_of
from onika.model.redirect import Redirect
from onika.words.condition import Condition
from onika.words.reason import Reason, reason_of

SLOWEST, FASTEST = 0.01, 1000.0


def directory(text: str) -> str:
    """A directory on the command line; raises ArgumentTypeError where there is none."""
    if not Path(text).is_dir():
        raise argparse.ArgumentTypeError(say(Reason.of("cli.directory_expected", text=text)))
    return text


def script_file(text: str) -> Path:
    """A script on the command line; raises ArgumentTypeError where there is none."""
    path = Path(text)
    if not path.is_file():
        raise argparse.ArgumentTypeError(say(Reason.of("cli.script_expected", text=text)))
    return path


def scale(text: str) -> float:
    """How many times as fast as wall time; raises ArgumentTypeError beyond reason."""
    try:
        number = float(text)
    except ValueError:
        number = 0.0
    if not SLOWEST <= number <= FASTEST:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.scale_expected", least=SLOWEST, most=FASTEST, text=text)))
    return number


def expectation_of(text: str) -> Condition:
    """A condition, as a word of a command line."""
    try:
        return Condition.parse(text)
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def redirect_of(text: str) -> Redirect:
    """A redirection, as a word of a command line."""
    try:
        return Redirect.parse(text)
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def runtime_address(text: str) -> str:
    """The address of a runtime, as a word of a command line."""
    try:
        return str(address_of(text))
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def seconds_of(text: str) -> float:
    """Seconds, as a word of a command line."""
    try:
        seconds = float(text)
    except ValueError:
        seconds = -1.0
    if not 0.0 <= seconds <= 3600.0:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.seconds_expected", most="3600", text=text)))
    return seconds


def answer_of(text: str) -> tuple[str, str, str]:
    """A task, the name of an input and its values, as a word of a command line."""
    address, equals, values = text.partition("=")
    task, dot, name = address.strip().rpartition(".")
    if not (equals and dot and task and name):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.answer_expected", text=text)))
    return task, name, values.replace(",", " ").strip()


def joined_answers(answers: list[tuple[str, str, str]]) -> tuple[tuple[str, str, str], ...]:
    """One line of values for each input, in the order in which they were given."""
    lines: dict[tuple[str, str], list[str]] = {}
    for task, name, values in answers:
        lines.setdefault((task, name), []).append(values)
    return tuple((task, name, " ".join(parts)) for (task, name), parts in lines.items())
