"""The source of a sweep: one cycle of each of some tasks, in order, as the loop that one would write by hand.

What a sweep does is what the executive does task by task (laws 1 to 5), for the case that nothing happens beside. It
ends at the first task that has a signal, a warning or a fault, and says which: all else is the executive's. What a task
of the sweep has just published is copied from its own buffer, for nobody else has written since. The clock is read once
between two cycles; the times are counted later, all at once.
"""

import keyword
import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from onika.ring.slots import LONGEST_SEALED, SEALS, STRANGE, last_of


@dataclass(frozen=True, slots=True)
class SweepPort:
    """A port that moves in every cycle: subsystem and name of its variable, where it lies, the bytes of a value."""

    subsystem: str
    svar: str
    offset: int
    size: int


@dataclass(frozen=True, slots=True)
class SweepMember:
    """A task of a sweep."""

    subsystem: str
    name: str
    is_hardware: bool
    inputs: tuple[SweepPort, ...]
    outputs: tuple[SweepPort, ...]


@dataclass(frozen=True, slots=True)
class SweepName:
    """A name in the source: what it stands for, of which member (-1: of none), and of which of its ports."""

    name: str
    meaning: str
    member: int = -1
    port: int = -1


@dataclass(slots=True)
class SweepSource:
    """The text, which defines `sweep(now)`, and all names it takes from outside."""

    text: str = ""
    names: list[SweepName] = field(default_factory=list)


_OUTSIDE = ("ALL", "clock", "lap", "laps", "running", "seal_of", "zero")
_WITHIN = ("at", "count", "now", "seconds", "signal", "sweep", "wrong")


def sweep_source(members: Sequence[SweepMember], *, notes_name: bool = False) -> SweepSource:
    """The sweep of these tasks in this order; `notes_name`: whose code runs is noted in shared memory too."""
    source = SweepSource(names=[SweepName(name, name) for name in _OUTSIDE])
    names = _Names(source)
    titles = [f"{member.subsystem}/{member.name}" for member in members]
    lines = [
        "def sweep(now):",
        f"    {', '.join(titles)!r}",
        "    running.calls += 1",
        "    seconds, at = now * 1e-9, 0",
        "    lap[0] = clock()",
        "    try:",
    ]
    published: dict[SweepPort, str] = {}
    written = {port for member in members for port in member.outputs}
    for place, member in enumerate(members):
        block = _Block(names, place, member)
        body = [
            *block.beginning(notes_name=notes_name),
            *(block.guarded_cycle() if member.is_hardware else block.cycle(published, written)),
            *block.copies_out(published),
            *block.ending(),
        ]
        lines += [f"        {line}" if line else "" for line in body]
    lines += ["    except BaseException as wrong:", "        return at, None, wrong"]
    lines += ['    running.task = ""', "    laps.extend(lap)", "    return None", ""]
    source.text = "\n".join(lines)
    return source


class _Names:
    """Gives each thing that is meant one name, alike in no two; the wish is a task and a variable in letters."""

    def __init__(self, source: SweepSource) -> None:
        self._source = source
        self._given: dict[tuple[object, ...], str] = {}
        self._taken = {*_OUTSIDE, *_WITHIN}

    def of(self, wish: str, meaning: str, member: int, port: int = -1, thing: object = None) -> str:
        """The name of what is meant; things that are equal are one, and otherwise it is of this member's port."""
        key = (meaning, member, port) if thing is None else (thing,)
        name = self._given.get(key)
        if name is None:
            name = self._given[key] = self._free(wish)
            self._source.names.append(SweepName(name, meaning, member, port))
        return name

    def _free(self, wish: str) -> str:
        plain = re.sub(r"\W", "_", wish.replace("^", "D"), flags=re.ASCII)
        if not plain[:1].isalpha() or keyword.iskeyword(plain):
            plain = f"task_{plain}"
        name, number = plain, 1
        while name in self._taken:
            number += 1
            name = f"{plain}_{number}"
        self._taken.add(name)
        return name


class _Block:
    """The lines of one task."""

    def __init__(self, names: _Names, place: int, member: SweepMember) -> None:
        self._names = names
        self._place = place
        self._member = member
        self._module = names.of(member.name, "module", place)

    def beginning(self, *, notes_name: bool) -> list[str]:
        member, place = self._member, self._place
        title = f"{member.subsystem}/{member.name}"
        lines = ["", f"# {title!r}"] + ([f"at = {place}"] if place else [])
        lines.append(f"running.task = {title!r}")
        if notes_name:
            memory = self._names.of("last_words", "memory", -1, thing="memory")
            lines.append(f"{memory}[ALL] = {self._names.of(f'{member.name}_name', 'name', place)}")
        return lines

    def guarded_cycle(self) -> list[str]:
        """Of hardware: whether its inputs are fresh, finite and steady is looked at by its guard, which takes them."""
        guard = self._names.of(f"{self._member.name}_guard", "guard", self._place)
        return [
            f"if {guard}.take_in(now):",
            f"    signal = {self._module}.cycle()",
            "else:",
            f"    {self._module}.hold()",
            "    signal = None",
        ]

    def cycle(self, published: dict[SweepPort, str], written: set[SweepPort]) -> list[str]:
        lines = []
        for number, port in enumerate(self._member.inputs):
            target = self._buffer("input", port, number)
            if port in published:
                lines.append(f"{target}[ALL] = {published[port]}")
                continue
            words, slots = self._ring(port, "input", number)
            newest = f"{slots}[{words}[0] & {last_of(port.size)}]"
            if port in written and port.size <= LONGEST_SEALED:  # in each sweep, later: it is another one every time
                lines.append(f"{target}[ALL] = {newest}")
                continue
            seen = self._names.of(f"{self._member.name}_{port.svar}_seen", "seen", self._place, number)
            lines += [
                f"if {seen}[0] != {words}[0]:",
                f"    {target}[ALL] = {newest}",
                f"    {seen}[0] = {words}[0]",
            ]
        return [*lines, f"{self._module}.now = seconds", f"signal = {self._module}.cycle()"]

    def copies_out(self, published: dict[SweepPort, str]) -> list[str]:
        lines = []
        for number, port in enumerate(self._member.outputs):
            buffer = self._buffer("output", port, number)
            words, slots = self._ring(port, "output", number)
            own = self._names.of(f"{port.svar}_own", "own", self._place, number)
            lines += [
                f"count = {words}[0]",
                f"if count != {own}[0]: {words}[{STRANGE}] += 1",
                "count += 1",
                f"{slots}[count & {last_of(port.size)}][ALL] = {buffer}",
            ]
            if port.size <= LONGEST_SEALED:
                lines.append(f"if not count & 7: {words}[{SEALS}] = seal_of({buffer}, count)")
            lines.append(f"{words}[0] = {own}[0] = count")
            published[port] = buffer
        return lines

    def ending(self) -> list[str]:
        warnings = self._names.of(f"{self._member.name}_warnings", "warnings", self._place)
        return [
            f"lap[{self._place + 1}] = clock()",
            f"if (signal is not None and signal is not zero) or {warnings}: return {self._place}, signal, None",
        ]

    def _buffer(self, meaning: str, port: SweepPort, number: int) -> str:
        return self._names.of(f"{self._member.name}_{port.svar}", meaning, self._place, number)

    def _ring(self, port: SweepPort, way: str, number: int) -> tuple[str, str]:
        return (
            self._names.of(f"{port.svar}_words", f"{way} words", self._place, number, ("words", port)),
            self._names.of(f"{port.svar}_slots", f"{way} slots", self._place, number, ("slots", port)),
        )
