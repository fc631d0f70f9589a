"""The command line: one small file per command, no logic."""

import gc


def main(words: list[str] | None = None) -> int:
    """Carry out a command line; the exit code."""
    gc.disable()  # what is loaded stays: to look through it for garbage takes a tenth of the time
    try:
        from onika.cli.commands import carry_out  # within: a Ctrl-C while libraries load is an end like any other

        return carry_out(words)
    except KeyboardInterrupt:
        return 130
    finally:
        gc.enable()
