"""What a process costs with all that it has started: memory and processor time, read from /proc (requirement X25)."""

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

_TICKS = os.sysconf("SC_CLK_TCK")
_PAGE = os.sysconf("SC_PAGE_SIZE")
_PARENT, _USER_TIME, _SYSTEM_TIME, _RESIDENT = 1, 11, 12, 21
"""Words behind the name in /proc/PID/stat, from 0."""


@dataclass(frozen=True, slots=True)
class Footprint:
    """Of a family of processes; memory that several share is counted for each."""

    bytes: int = 0
    processor_s: float = 0.0
    processes: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class _Process:
    parent: int
    bytes: int
    processor_s: float


def footprints(roots: Iterable[int], proc: Path = Path("/proc")) -> Mapping[int, Footprint]:
    """Of each of these processes and its descendants; nothing of one that is gone."""
    processes = dict(_processes(proc))
    children: dict[int, list[int]] = {}
    for number, process in processes.items():
        children.setdefault(process.parent, []).append(number)
    return {root: _sum(root, processes, children) for root in roots}


def _processes(proc: Path) -> Iterable[tuple[int, _Process]]:
    for path in proc.glob("[0-9]*/stat"):
        try:
            words = path.read_text("ascii", "replace").rpartition(")")[2].split()
            resident = max(0, int(words[_RESIDENT])) * _PAGE
            time_s = (int(words[_USER_TIME]) + int(words[_SYSTEM_TIME])) / _TICKS
            yield int(path.parent.name), _Process(int(words[_PARENT]), resident, time_s)
        except (OSError, ValueError, IndexError):
            continue  # it has ended meanwhile


def _sum(root: int, processes: Mapping[int, _Process], children: Mapping[int, list[int]]) -> Footprint:
    family = [root] if root in processes else []
    for number in family:
        family += children.get(number, ())
    return Footprint(
        sum(processes[number].bytes for number in family),
        sum(processes[number].processor_s for number in family),
        tuple(family),
    )
