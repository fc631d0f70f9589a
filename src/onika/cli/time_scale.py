"""The scale of virtual time on a command line."""

import argparse

SLOWEST, FASTEST = 0.01, 1000.0


def scale(text: str) -> float:
    """How many times as fast as wall time; raises ArgumentTypeError beyond reason."""
    try:
        number = float(text)
    except ValueError:
        number = 0.0
    if not SLOWEST <= number <= FASTEST:
        raise argparse.ArgumentTypeError(f"expected a number from {SLOWEST:g} to {FASTEST:g}, found {text!r}")
    return number
