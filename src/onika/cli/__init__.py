"""The command line: one small file per command, no logic."""

import gc
import os


def main(words: list[str] | None = None) -> int:
    """Carry out a command line; the exit code."""
    _open_standard()
    gc.disable()  # what is loaded stays: to look through it for garbage takes a tenth of the time
    try:
        from onika.cli.commands import carry_out  # within: a Ctrl-C while libraries load is an end like any other

        return carry_out(words)
    except KeyboardInterrupt:
        return 130
    finally:
        gc.enable()


def _open_standard() -> None:
    """Started without input or outputs, a program has them lead nowhere: what it opens next would stand for them."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # it gets the lowest number that is free: this one
