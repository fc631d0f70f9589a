"""The command line: one small file per command, no logic."""

import os
import sys


def main(words: list[str] | None = None) -> int:
    """Carry out a command line; the exit code."""
    try:
        from onika.cli.commands import carry_out  # within: a Ctrl-C while libraries load is an end like any other

        code = carry_out(words)
        if sys.stdout is not None:
            sys.stdout.flush()
        return code
    except KeyboardInterrupt:
        return _say("stopped", 130)
    except BrokenPipeError:
        _drop_output()  # whoever read our output has seen enough; what was to be done was not done
        return 1
    except OSError as wrong:
        _drop_output()
        return _say(f"onika: {wrong}", 1)
    except UnicodeError as wrong:
        return _say(f"onika: this terminal's letters do not suffice ({wrong}); set PYTHONUTF8=1", 1)


def _say(text: str, code: int) -> int:
    if sys.stderr is not None:
        sys.stderr.write(text.encode("ascii", "backslashreplace").decode() + "\n")
    return code


def _drop_output() -> None:
    """So that the interpreter does not complain once more when it ends."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
