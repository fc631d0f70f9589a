"""Writes what is drawn from the code: engine, lifecycles, laboratory, messages, the house, what the page knows of them.

Usage: python tools/generate.py [--check] [--root ROOT]. Writes each file anew; with --check it writes nothing, names
the files that differ from the code and ends with 1 if any does.
"""

import argparse
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from inspect import cleandoc, getsourcefile
from pathlib import Path
from types import ModuleType
from typing import TypeVar

import catalogues
import engine_page
import house_picture
import message_page
import typescript
import unit_table
from onika.desk.plan.compile import UNKNOWN, planned_task
from onika.engine import flow
from onika.host.units.world_registry import open_world, split
from onika.link import state
from onika.model import lifecycle
from onika.model.application import Application, actions
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.wiring import WiredTask, wire
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped, shipped_directories
from onika.store.site import Site
from onika.store.world_source import gather_world
from onika.wire.sheet import InputSheet, ModuleSheet
from onika.words.fault import Fault

ROOT = Path(__file__).parents[1]

_LIFECYCLES = (("A task", lifecycle), ("A flow", flow), ("A link", state))

_HEAD = """\
# Lifecycles

Each lifecycle is one table in one file; what the table does not list cannot happen. This page is drawn from the tables
by `python tools/generate.py`: change a table, then call it again.
"""

_LABORATORY = """\
# The laboratory

Everything that is shipped and may be used in programs of your own; [guide 8](guide/08-a-configuration.md) puts some
of it together. This page is drawn from the files and classes themselves by `python tools/generate.py`. "In" names the
base directory, a folder of `src/onika/labs`.
"""

_T = TypeVar("_T")
_FLAGS = ("trigger", "passive", "hardware")


@dataclass(frozen=True)
class _Shipped:
    """A task with its base directory, its class and its ports by their names in the table."""

    home: str
    task: Task
    sheet: ModuleSheet
    wired: WiredTask

    @classmethod
    def read(cls, name: str, base: BaseDirectory, site: Site) -> "_Shipped":
        task = _sure(base.task(name)).task
        path = site.code_file(task)
        if path is None:
            raise ValueError(f"expected the code of module {task.module}, found none")
        found = load(path.read_text(encoding="utf-8"), str(path), task.module)
        if isinstance(found, Fault):
            raise ValueError(str(found))
        sheet = sheet_of(found)
        wired = wire(planned_task(task, UNKNOWN, "", str(base.task_file(name))), sheet)
        return cls(base.path.name, task, sheet, wired)


def lifecycles() -> str:
    """The page of the three lifecycles: what the file says of itself, then its diagram."""
    return "\n".join([_HEAD, *(_section(title, code) for title, code in _LIFECYCLES)])


def laboratory() -> str:
    """The page of what is shipped: tasks, jobs, targets, applications, types, variables and devices."""
    site = Site(tuple(BaseDirectory(path) for path in shipped_directories()), shipped() / "prefs")
    syntax = _sure(site.syntax())
    tasks = [_Shipped.read(name, base, site) for base in site.directories for name in base.tasks]
    parts = (
        _LABORATORY,
        "## Jobs\n\nThe tasks stand in the order of the configuration.\n",
        _jobs(site, syntax),
        "## Targets\n\nOne line of values per data item of the type.\n",
        _targets(site, syntax),
        "## Types of targets\n\nUnits are those of the task that takes the target.\n",
        _target_types(syntax, tasks),
        "## Applications\n",
        _applications(site, syntax),
        "## Devices\n\nA task names its device in its LOCAL block: `DEVICE world:device`. Units are SI.\n",
        _devices(tasks, site),
        "## State variables\n",
        _variables(tasks),
        "## Tasks\n",
        *(_task(one) for one in tasks),
    )
    return "\n".join(parts)


PAGES: Mapping[str, Callable[[], str]] = {
    "docs/engine.md": engine_page.page,
    "docs/lifecycles.md": lifecycles,
    "docs/laboratory.md": laboratory,
    "docs/messages.md": message_page.page,
    "docs/pictures/house.svg": house_picture.picture,
    "browser/src/api.gen.ts": typescript.source,
    "browser/src/texts/catalogue.es.gen.ts": partial(catalogues.source, "es"),
    "browser/src/values/units.gen.ts": unit_table.source,
}
"""Every generated file by its path in the repository."""


def stale(root: Path) -> dict[str, str]:
    """The generated files under `root` that are missing or differ from what the code says now, as they ought to be."""
    pages = {path: page() for path, page in PAGES.items()}
    return {path: text for path, text in pages.items() if _content(root / path) != text}


def write(root: Path) -> list[str]:
    """Bring every generated file under `root` up to date; those that were changed."""
    changed = stale(root)
    for path, text in changed.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text, encoding="utf-8")
    return list(changed)


def _content(path: Path) -> str | None:
    return path.read_text(encoding="utf-8") if path.is_file() else None


def _section(title: str, code: ModuleType) -> str:
    source = "/".join(Path(getsourcefile(code) or "").parts[-4:])
    said = cleandoc(code.__doc__ or "")
    return f"## {title}\n\n`{source}` says:\n\n```text\n{said}\n```\n\n```mermaid\n{code.diagram()}```\n"


def _sure(read: tuple[_T | None, tuple[Fault, ...]]) -> _T:
    """What was read; raises ValueError where it is missing or has faults."""
    if read[0] is None or read[1]:
        raise ValueError("; ".join(map(str, read[1])) or "expected a file, found none")
    return read[0]


def _grid(heads: str, rows: Iterable[Iterable[str]]) -> str:
    """A table; `heads` are parted by commas. Nothing where there are no rows."""
    lines = [f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in row)} |" for row in rows]
    names = heads.split(",")
    head = [f"| {' | '.join(names)} |", "|---" * len(names) + "|"]
    return "\n".join([*head, *lines, ""]) if lines else ""


def _code(words: Iterable[str]) -> str:
    return " ".join(f"`{word}`" for word in words)


def _jobs(site: Site, syntax: Syntax) -> str:
    rows = []
    for base in site.directories:
        for name in base.configurations:
            icon = _sure(site.onikon(name, syntax))
            takes = ", ".join((syntax.target_type_of(icon.type) or "none", *icon.more_targets))
            tasks = (placed.task for placed in _sure(base.configuration(name)).placed)
            rows.append((f"`{name}`", base.path.name, icon.description, icon.type, takes, _code(tasks)))
    return _grid("job,in,what it does,type,target,tasks", rows)


def _targets(site: Site, syntax: Syntax) -> str:
    rows = []
    for base in site.directories:
        for name in base.onikons:
            icon = _sure(base.onikon(name, syntax))
            kind = syntax.find(icon.type)
            if kind and kind.is_target:
                values = "<br>".join(" ".join(map(str, line)) for line in icon.values)
                rows.append((f"`{name}`", base.path.name, icon.description, icon.type, values))
    return _grid("target,in,what it is,type,values", rows)


def _target_types(syntax: Syntax, tasks: list[_Shipped]) -> str:
    rows = []
    for kind in syntax.types:
        takers = [one for one in tasks if kind.name == syntax.target_type_of(one.task.object_type or "")]
        units = {asked.name: asked.unit for one in takers for asked in one.sheet.inputs}
        for item in kind.items:
            count = f"{item.type.value}[{item.dimension or item.count}]" if item.count > 1 else item.type.value
            taken = _code(one.task.name for one in takers) or "no shipped task"
            rows.append((kind.name, f"`{item.name}`", count, units.get(item.name, ""), taken))
    return _grid("type,data item,values,unit,taken by", rows)


def _applications(site: Site, syntax: Syntax) -> str:
    rows = []
    for base in site.directories:
        for name in base.applications:
            application = _sure(base.application(name, syntax))
            counts = ", ".join(str(len(list(actions(one, syntax)))) for one in application.flows)
            used = _code(sorted(set(_jobs_of(application, syntax))))
            rows.append((f"`{name}`", base.path.name, str(len(application.flows)), counts, used))
    return _grid("application,in,flows,actions of each,jobs it uses", rows)


def _jobs_of(application: Application, syntax: Syntax) -> Iterator[str]:
    for one in application.flows:
        for _, icon, _ in actions(one, syntax):
            yield icon.onikon.name


def _devices(tasks: list[_Shipped], site: Site) -> str:
    worlds = {split(one.wired.device)[0] for one in tasks if one.wired.device}
    rows = []
    for world in sorted(worlds):
        files, _ = gather_world(world, site)
        for sheet in open_world(world, files=files).devices() if files else ():
            name = f"{world}:{sheet.name}"
            users = _code(one.task.name for one in tasks if one.wired.device == name)
            rows.append((f"`{name}`", _code(sheet.state[2:]), _code(sheet.command) or "none", users))
    return _grid("device,fields it publishes,fields of a command,tasks", rows)


def _variables(tasks: list[_Shipped]) -> str:
    shapes: dict[str, dict[tuple[str, str], None]] = {}
    ends: dict[str, tuple[list[str], list[str]]] = {}
    for one in tasks:
        for port in one.wired.ports:
            shapes.setdefault(port.svar, {})[str(port.shape), port.unit] = None
            ends.setdefault(port.svar, ([], []))[port.kind.is_input].append(one.task.name)
    rows = []
    for svar, (writers, readers) in sorted(ends.items()):
        types, units = (" or ".join(dict.fromkeys(part)) for part in zip(*shapes[svar], strict=True))
        rows.append((f"`{svar}`", types, units, _code(writers) or "none", _code(readers) or "none"))
    return _grid("variable,type,unit,written by,read by", rows)


def _task(one: _Shipped) -> str:
    """The section of one task."""
    task, sheet = one.task, one.sheet
    rate = f"{task.frequency:g} Hz" if task.frequency else task.type.value
    said = [f"Module `{task.module}`", rate, *(flag for flag in _FLAGS if getattr(sheet, flag))]
    if task.object_type:
        said.append(f"takes the target of a {task.object_type}")
    if one.wired.device:
        said.append(f"device `{one.wired.device}`")
    ports = (
        (port.kind.value, _named(port.port, port.svar), str(port.shape), port.unit, declared.meaning)
        for port, declared in zip(one.wired.ports, sheet.ports, strict=True)
    )
    given = {line.key: " ".join(line.words) for line in task.local}
    parameters = (
        (
            f"`{local.name}`",
            local.shape,
            local.unit,
            given.get(local.name, "not given"),
            _default(local.default),
            local.meaning,
        )
        for local in sheet.locals
    )
    inputs = ((f"`{asked.name}`", asked.shape, asked.unit, _bounds(asked), asked.meaning) for asked in sheet.inputs)
    parts = (
        f"### `{task.name}`\n\nIn `{one.home}`: {task.description}. {', '.join(said)}.\n",
        _grid("port,variable,type,unit,meaning", ports),
        _grid("parameter,type,unit,here,default,meaning", parameters),
        _grid("input,type,unit,bounds,meaning", inputs),
    )
    return "\n".join(part for part in parts if part)


def _named(port: str, svar: str) -> str:
    return f"`{svar}`" if port == svar else f"`{svar}` (`{port}` in the code)"


def _default(value: object) -> str:
    return "none: must be given" if value is None else str(value)


def _bounds(asked: InputSheet) -> str:
    low, high = (
        "" if bound is None else f"`{bound}`" if isinstance(bound, str) else f"{bound:g}"
        for bound in (asked.low, asked.high)
    )
    return f"{low} to {high}" if low and high else f"from {low}" if low else f"up to {high}" if high else "none"


def main(words: list[str]) -> int:
    """Write, or with --check only compare; 1 if a file differs."""
    parser = argparse.ArgumentParser(description="Writes what is drawn from the code into docs/.")
    parser.add_argument("--check", action="store_true", help="write nothing; 1 if a file is not up to date")
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository")
    given = parser.parse_args(words)
    if not given.check:
        for path in write(given.root):
            print(path)
        return 0
    found = stale(given.root)
    for path in found:
        print(f"{path} is not what the code says: python tools/generate.py")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
