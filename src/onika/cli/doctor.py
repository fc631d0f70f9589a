"""`onika doctor`: say what this machine offers and what that costs."""

import argparse

from rich.console import Console
from rich.text import Text

from onika.cli.language import say
from onika.desk.run.machine import features
from onika.words.reason import Reason

_COLUMN = 14
"""Columns for the name of a thing."""


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_doctor")


def describe(parser: argparse.ArgumentParser) -> None:
    """It takes nothing."""
    del parser


def carry_out(given: argparse.Namespace) -> int:
    """Look and say; 0 if everything is there, 1 if something is missing."""
    del given
    console, missing = Console(highlight=False), 0
    for offer in features():
        missing += not offer.is_there
        mark = (
            _mark(Reason.of("cli.doctor_ok"), "green") if offer.is_there else _mark(Reason.of("cli.doctor_no"), "red")
        )
        console.print(mark, Text(f"{say(offer.name):<{_COLUMN}}"), Text(say(offer.actual)), sep="")
        if not offer.is_there:
            cost = say(Reason.of("cli.doctor_cost", cost=offer.cost))
            console.print(Text(f"    {'':<{_COLUMN}}{cost}", style="yellow"))
    return 1 if missing else 0


def _mark(word: Reason, style: str) -> Text:
    return Text(f"{say(word):<4}", style=style)
