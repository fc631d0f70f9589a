"""A laboratory for one test: a base directory whose files are written as texts, so that anything can be planted in it.

    lab = Laboratory(tmp_path)
    lab.module("wink", source)
    lab.task("wink", "MODULE wink …")
    lab.configuration("winkC", "wink 100", "jtraj 250 rt1")
    lab.application("twice", [job("winkC"), job("winkC")])

What it does not hold is found where it always is: in the shipped laboratories.
"""

from collections.abc import Sequence
from pathlib import Path

_PICTURE = f"PICT        {'8' * 32}\n" * 32
HOLE = "ICONHOLE\n"
"""A step that is missing."""


def job(name: str, kind: str = "Complete job", *marks: str) -> str:
    """The icon of a job as it stands in an application; `marks` are whole lines (`SYNCHTAG meet`)."""
    lines = [
        f"ROUTINE     {name}",
        "MARKER      no",
        *marks,
        f"ONIKON      {kind}",
        "DESC        a job",
        "UI          none",
    ]
    return "\n".join(lines) + "\n" + _PICTURE


def target(name: str, kind: str, *values: str) -> str:
    """The icon of a target, one line of values for each item of its type."""
    lines = [f"ROUTINE     {name}", "MARKER      no", f"ONIKON      {kind}", "DESC        a target"]
    return "\n".join([*lines, *(f"UI          {value}" for value in values)]) + "\n" + _PICTURE


def joints(name: str, *angles: float, duration: float = 1.0) -> str:
    """A joint target in rad and s."""
    return target(name, "Joint object", " ".join(map(str, angles)), str(duration))


class Laboratory:
    """A base directory at `path`; every call writes one file and gives its path."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def module(self, name: str, source: str) -> Path:
        """The code of a module."""
        return self._write("module", f"{name}.py", source)

    def task(self, name: str, text: str) -> Path:
        """A task by the lines of its `.rmod`, without the last one."""
        return self._write("module", f"{name}.rmod", f"{text.strip()}\n\nEOF\n")

    def plain_task(
        self, name: str, *, reads: str = "none", writes: str = "none", hz: float = 100, local: str = ""
    ) -> Path:
        """A periodic task of the module of its own name, by its INVARs, its OUTVARs and its LOCAL lines."""
        rows = (
            f"MODULE      {name}\nDESC        a task\nINCONST     none\nOUTCONST    none\n"
            f"INVAR       {reads}\nOUTVAR      {writes}\nTASKTYPE    periodic\nFREQ        {hz:g}\n"
        )
        return self.task(name, rows + (f"\nLOCAL\n{local}" if local else ""))

    def configuration(self, name: str, *placed: str) -> Path:
        """A configuration of tasks, each `TASK FREQ [RTPU]`."""
        blocks = []
        for placement in placed:
            task, frequency, *rtpu = placement.split()
            unit = rtpu[0] if rtpu else "unknown"
            blocks.append(
                f"RMODFILE    {task}\nCOORDS      9 9\nINLEFT      yes\nFREQ        {frequency}\nRTPU        {unit}\n"
            )
        return self._write("conf", f"{name}.conf", "\n".join(["VERSION     1.3\n", *blocks, "EOF\n"]))

    def application(self, name: str, *flows: Sequence[str], parallel: bool = False) -> Path:
        """An application of flows of icons."""
        kind = "parallel" if parallel else "conditional"
        parts = ["VERSION     1.3\n", f"APPLTYPE    {kind}\n"]
        for flow in flows:
            parts += ["FLOW\n", *flow, "ENDFLOW\n"]
        return self._write("appl", f"{name}.appl", "\n".join([*parts, "EOF\n"]))

    def _write(self, folder: str, name: str, text: str) -> Path:
        path = self.path / folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path
