"""A shipped job with other tasks dropped in, or with variables that are called otherwise there."""

from collections.abc import Mapping, Sequence

from kit.labs.laboratory import Laboratory
from onika.store.shipped import shipped


def placed(task: str, frequency: float, *lines: str) -> str:
    """The block of a task in a configuration of version 2.0; `lines` are whole (`LOCAL       AFTER 0.4`)."""
    rows = [
        f"RMODFILE    {task}",
        "COORDS      9 9",
        "INLEFT      yes",
        f"FREQ        {frequency:g}",
        "RTPU        unknown",
    ]
    return "\n".join([*rows, *lines]) + "\n"


def varied(
    lab: Laboratory,
    name: str,
    shipped_job: str,
    dropped_in: Sequence[str] = (),
    lines: Mapping[str, str] | None = None,
    without: Sequence[str] = (),
) -> None:
    """Write configuration `name`: that of a shipped job with further tasks behind its first one.

    `dropped_in` are blocks, `lines` go behind those of the tasks of these names, tasks `without` are left out.
    """
    own = lines or {}
    text = next(shipped().glob(f"*/conf/{shipped_job}.conf")).read_text(encoding="utf-8")
    blocks = {
        block.split()[1]: f"{block}\n" for block in text.partition("\nLOCUS")[0].partition("\nEOF")[0].split("\n\n")[1:]
    }
    kept = [block.rstrip("\n") + "\n" + own.get(task, "") for task, block in blocks.items() if task not in without]
    path = lab.path / "conf" / f"{name}.conf"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(["VERSION     2.0\n", kept[0], *dropped_in, *kept[1:], "EOF\n"]), encoding="utf-8")
