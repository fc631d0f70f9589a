"""The scale of virtual time on a command line."""

import argparse

from onika.cli.language import say
from onika.words.reason import Reason

SLOWEST, FASTEST = 0.01, 1000.0


def scale(text: str) -> float:
    """How many times as fast as wall time; raises ArgumentTypeError beyond reason."""
    try:
        number = float(text)
    except ValueError:
        number = 0.0
    if not SLOWEST <= number <= FASTEST:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.scale_expected", least=SLOWEST, most=FASTEST, text=text)))
    return number
