"""The command line: one small file per command, no logic."""


def main(words: list[str] | None = None) -> int:
    """Carry out a command line; the exit code."""
    try:
        from onika.cli.commands import carry_out  # within: a Ctrl-C while libraries load is an end like any other

        return carry_out(words)
    except KeyboardInterrupt:
        return 130
