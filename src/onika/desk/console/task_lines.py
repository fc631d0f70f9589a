"""Console commands for the life of tasks: spawn, on, off, kill, clear, config (requirements A05, A13, A14)."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import msgspec

from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.site_library import SiteLibrary, altered
from onika.desk.plan.compile import UNKNOWN
from onika.model.configuration import Configuration
from onika.model.planned import task_of
from onika.wire import live
from onika.wire.plan import Code, PlannedTask
from onika.wire.runtime_standing import TaskStanding
from onika.words.reason import Reason

Words = tuple[str, ...]
ALL = "all"


@dataclass(frozen=True, slots=True)
class _SpawnLine:
    """What `spawn` was told: names, and what follows them."""

    names: Words
    rtpu: str = UNKNOWN
    name: str = ""
    frequency: float | None = None


def spawn(session: ConsoleSession, words: Words) -> Faults:
    """Bring tasks to life, OFF."""
    if words[:2] == (ALL, "of"):
        return _spawn_all(session, words[2:])
    wish = _wish(session, words)
    if not isinstance(wish, _SpawnLine):
        return wish
    if wish.name and len(wish.names) != 1:
        return session.no(Reason.of("console.one_task_before_as", count=len(wish.names)))
    subsystem, _ = session.address(wish.names[0])
    planned: list[PlannedTask] = []
    code: dict[str, Code] = {}
    faults: Faults = _unit_there(session, wish.rtpu)
    for address in wish.names:
        home, name = session.address(address)
        if home != subsystem:
            faults += session.no(Reason.of("console.one_subsystem", subsystem=subsystem, home=home))
        task, source, wrong = SiteLibrary(session.site, session.place).planned(name, wish.rtpu)
        faults += wrong
        if task is not None and source is not None:
            planned.append(altered(task, wish.name, wish.frequency))
            code[source.digest] = source
    return faults or _born(session, live.Change(subsystem, spawn=tuple(planned), code=tuple(code.values())))


def on(session: ConsoleSession, words: Words) -> Faults:
    """Turn a task ON, with its argument line; `all` turns all ON that are OFF."""
    if words == (ALL,):
        resting = [name for name, task in session.tasks().items() if task.state == "OFF"]
        return session.order(live.Change(session.subsystem, on=tuple(live.Turn(name) for name in resting)))
    subsystem, name = session.address(words[0])
    line, faults = SiteLibrary(session.site, session.place).arguments(words[1] if len(words) > 1 else "")
    faults = faults or missing(session, subsystem, (name,))
    return faults or session.order(live.Change(subsystem, on=(live.Turn(name, line),)))


def off(session: ConsoleSession, words: Words) -> Faults:
    """Turn tasks OFF; all of them where none is named."""
    if words in ((), (ALL,)):
        moving = tuple(name for name, task in session.tasks().items() if task.state in ("ON", "ASKING"))
        if moving:
            return session.order(live.Change(session.subsystem, off=moving))
        return ()
    return _several(session, words, lambda subsystem, names: live.Change(subsystem, off=names))


def kill(session: ConsoleSession, words: Words) -> Faults:
    """End tasks, or all of the subsystem, which then is no more."""
    if words == (ALL,):
        if session.tasks():
            return session.order(live.Close(session.subsystem))
        return ()
    return _several(session, words, lambda subsystem, names: live.Change(subsystem, kill=names))


def clear(session: ConsoleSession, words: Words) -> Faults:
    """Bring a task out of ERROR, or, without a name, every task of the subsystem that is in it."""
    if not words:
        broken = [name for name, task in session.tasks().items() if task.state == "ERROR"]
        return _clear_all(session, broken)
    subsystem, name = session.address(words[0])
    return missing(session, subsystem, (name,)) or session.order(live.Clear(subsystem, name))


def _clear_all(session: ConsoleSession, broken: Sequence[str]) -> Faults:
    """Clear these; a device waits until those are cleared that feed it, wherever they stand in the list."""
    faults: Faults = ()
    while broken:
        refusals = {name: session.order(live.Clear(session.subsystem, name)) for name in broken}
        refused = [name for name, wrong in refusals.items() if wrong]
        faults = tuple(fault for name in refused for fault in refusals[name])
        if len(refused) == len(broken):
            break
        broken = refused
    return faults


def configure(session: ConsoleSession, words: Words) -> Faults:
    """Have exactly the tasks of a configuration, ON: what is in both keeps cycling untouched (requirement A13)."""
    return _reconfigured(session, words, lambda others: live.Change(session.subsystem, kill=tuple(others)))


def switch(session: ConsoleSession, words: Words) -> Faults:
    """Have the tasks of a configuration ON and all others OFF; who lives lives on, who lacks is spawned (C32)."""
    return _reconfigured(session, words, lambda others: live.Change(session.subsystem, off=_moving(others)))


def _moving(tasks: Mapping[str, TaskStanding]) -> Words:
    return tuple(name for name, task in tasks.items() if task.state in ("ON", "ASKING"))


def _reconfigured(
    session: ConsoleSession, words: Words, leave: Callable[[Mapping[str, TaskStanding]], live.Change]
) -> Faults:
    """The tasks of a configuration are ON; `leave` says what becomes of the others that live."""
    library = SiteLibrary(session.site, session.place)
    configuration, faults = library.configuration(words[0])
    line, wrong = library.arguments(words[1] if len(words) > 1 else "")
    if configuration is None or faults or wrong:
        return faults + wrong
    living = session.tasks()
    names = tuple(placed.task for placed in configuration.placed)
    same = _as_placed(library, configuration, living)
    planned, code, faults = _placed(session, configuration, same)
    resting = [name for name in names if name not in same or living[name].state != "ON"]
    files = {placed.task: placed.file for placed in configuration.placed}
    starts, wrong = _starts(library, resting, files, line)
    wrong += _useless(session, library, configuration, resting, line)
    others = {name: task for name, task in living.items() if name not in names}
    otherwise = tuple(name for name in living if name in names and name not in same)
    change = leave(others)
    change = msgspec.structs.replace(
        change,
        kill=(*change.kill, *otherwise),
        spawn=planned,
        code=code,
        on=starts,
        rates=tuple(_rates(configuration, living)),
    )
    return tuple(dict.fromkeys((*faults, *wrong))) or _born(session, change)


def _as_placed(library: SiteLibrary, configuration: Configuration, living: Mapping[str, TaskStanding]) -> set[str]:
    """The tasks that live as a configuration has them: with its aliases and parameters."""
    same = set()
    for placed in configuration.placed:
        task, _ = library.task(placed.file)
        if task is not None and placed.task in living:
            wanted, lives = placed.of(task), task_of(living[placed.task].task)
            same |= {placed.task} if (wanted.aliases, wanted.local) == (lives.aliases, lives.local) else set()
    return same


def _starts(
    library: SiteLibrary, names: Iterable[str], files: Mapping[str, str], line: str
) -> tuple[tuple[live.Turn, ...], Faults]:
    """What is to be turned ON; the argument line goes to the task that takes a target."""
    starts: list[live.Turn] = []
    faults: Faults = ()
    for name in names:
        task, wrong = library.task(files[name])
        faults += wrong
        if task is not None:
            starts.append(live.Turn(name, line if task.object_type else ""))
    return tuple(starts), faults


def _useless(
    session: ConsoleSession, library: SiteLibrary, configuration: Configuration, resting: Sequence[str], line: str
) -> Faults:
    """An argument line that nobody would take: no task takes a target, or those that do are ON already."""
    if not line:
        return ()
    tasks = {placed.task: library.task(placed.file)[0] for placed in configuration.placed}
    takers = tuple(name for name, task in tasks.items() if task is not None and task.object_type)
    if set(takers) & set(resting):
        return ()
    if takers:
        return session.no(Reason.of("console.takers_are_on", line=line, takers=takers))
    return session.no(Reason.of("console.nobody_takes", line=line, name=configuration.name))


def _rates(configuration: Configuration, living: Mapping[str, TaskStanding]) -> Iterator[tuple[str, float]]:
    """The rates that a configuration gives to tasks that live already and keep time."""
    for placed in configuration.placed:
        if placed.frequency and placed.task in living and living[placed.task].frequency is not None:
            yield placed.task, placed.frequency


def missing(session: ConsoleSession, subsystem: str, names: Words) -> Faults:
    """A fault for each task that does not live."""
    living = session.tasks(subsystem)
    absent = [name for name in names if name not in living]
    if living:
        reasons = [
            Reason.of("console.not_living", subsystem=subsystem, living=tuple(living), name=name) for name in absent
        ]
    else:
        reasons = [Reason.of("console.none_living", subsystem=subsystem, name=name) for name in absent]
    return tuple(fault for reason in reasons for fault in session.no(reason))


def _several(session: ConsoleSession, words: Words, change: Callable[[str, Words], live.Change]) -> Faults:
    """One change for each subsystem that is named."""
    groups: dict[str, list[str]] = {}
    for word in words:
        subsystem, name = session.address(word)
        groups.setdefault(subsystem, []).append(name)
    faults: Faults = ()
    for subsystem, names in groups.items():
        faults += missing(session, subsystem, tuple(names))
    if faults:
        return faults
    for subsystem, names in groups.items():
        faults += session.order(change(subsystem, tuple(names)))
    return faults


def _spawn_all(session: ConsoleSession, words: Words) -> Faults:
    if len(words) != 1:
        return session.no(Reason.of("console.spawn_all_usage", line=" ".join(("spawn", ALL, "of", *words))))
    configuration, faults = SiteLibrary(session.site, session.place).configuration(words[0])
    if configuration is None or faults:
        return faults
    planned, code, faults = _placed(session, configuration, set(session.tasks()))
    if faults or not planned:
        return faults
    return _born(session, live.Change(session.subsystem, spawn=planned, code=code))


def _born(session: ConsoleSession, change: live.Change) -> Faults:
    """Carry out a change whose newcomers bring the files of their worlds."""
    worlds, faults = SiteLibrary(session.site, session.place).worlds(change.spawn)
    return faults or session.order(msgspec.structs.replace(change, worlds=worlds))


def _placed(
    session: ConsoleSession, configuration: Configuration, living: set[str]
) -> tuple[tuple[PlannedTask, ...], tuple[Code, ...], Faults]:
    """The tasks of a configuration that do not live yet, on their units and at their rates."""
    planned: list[PlannedTask] = []
    code: dict[str, Code] = {}
    faults: Faults = ()
    units = {unit.name for unit in session.standing().rtpus}
    for placed in configuration.placed:
        if placed.task in living:
            continue
        rtpu = placed.rtpu if placed.rtpu in units else UNKNOWN  # as in a run: an unknown unit is the first one
        task, source, wrong = SiteLibrary(session.site, session.place).planned(placed.file, rtpu, placed)
        faults += wrong
        if task is not None and source is not None:
            planned.append(altered(task, "", placed.frequency if task.frequency is not None else None))
            code[source.digest] = source
    return tuple(planned), tuple(code.values()), faults


def _wish(session: ConsoleSession, words: Words) -> _SpawnLine | Faults:
    """`TASK… [on RTPU] [as NAME] [at HZ]`."""
    start = next((place for place, word in enumerate(words) if word in ("on", "as", "at")), len(words))
    names, rest = words[:start], words[start:]
    settings = dict(zip(rest[::2], rest[1::2], strict=False))
    if not names or len(rest) % 2 or len(settings) * 2 != len(rest) or set(settings) - {"on", "as", "at"}:
        return session.no(Reason.of("console.spawn_usage", words=" ".join(words)))
    frequency = None
    if "at" in settings:
        frequency = positive(settings["at"])
        if frequency is None:
            return session.no(Reason.of("console.rate_after_at", word=settings["at"]))
    return _SpawnLine(names, settings.get("on", UNKNOWN), settings.get("as", ""), frequency)


def positive(text: str) -> float | None:
    """A number above 0 and finite; None for anything else."""
    try:
        number = float(text)
    except ValueError:
        return None
    return number if 0.0 < number < float("inf") else None


def _unit_there(session: ConsoleSession, rtpu: str) -> Faults:
    units = [unit.name for unit in session.standing().rtpus]
    if rtpu == UNKNOWN or rtpu in units:
        return ()
    return session.no(Reason.of("console.unit_unknown", units=tuple(units), rtpu=rtpu))
