"""Console commands that only look: status, tasks, library, vars, read, check (requirements A06, A11, A12)."""

import fnmatch
import re
from collections.abc import Iterator
from typing import Any

from onika.desk.console import status as columns
from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.site_library import SiteLibrary
from onika.desk.console.task_lines import missing
from onika.desk.run.readings_text import types_of
from onika.desk.run.text_table import Cell
from onika.desk.run.value_text import in_a_line, shown
from onika.desk.run.world_text import drive_lines
from onika.model.planned import task_of
from onika.model.rules.worlds import worlds_of
from onika.wire import live, request
from onika.wire.runtime_standing import Standing, SubsystemStanding
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

Words = tuple[str, ...]
_TASK_HEAD = (Reason.of("console.head_task"), Reason.of("console.head_state"), Reason.of("console.head_rtpu"), "Hz", "")
_SUBSYSTEM_HEAD = (
    "",
    Reason.of("console.head_subsystem"),
    Reason.of("console.head_tasks"),
    Reason.of("console.head_holder"),
    Reason.of("console.head_moved"),
)
_VARIABLE_HEAD = (Reason.of("console.head_variable"), Reason.of("console.head_type"), Reason.of("console.head_value"))
_ELEMENT = re.compile(r"([^\[\]]+)\[(\d+(?:,\d+)*)\]\Z")


def status(session: ConsoleSession, words: Words) -> Faults:
    """Figures of all tasks in the columns that the user prefers, or every figure of the tasks named."""
    figures = session.ask(live.Status())
    if not isinstance(figures, live.Figures):
        return refused(session, Reason.of("console.figures"), figures)
    if not words:
        preferences, _ = session.site.preferences()
        session.show_table(*columns.overview(list(figures.tasks), preferences.status_columns))
    for word in words:
        subsystem, name = session.address(word)
        figures_of_task = [figure for figure in figures.tasks if (figure.subsystem, figure.task) == (subsystem, name)]
        if not figures_of_task:
            return missing(session, subsystem, (name,)) or session.no(Reason.of("console.no_figures", word=word))
        session.show(columns.whole(figures_of_task[0]))
    if figures.loads:
        loads = "  ".join(f"{name} {load:.1%}" for name, load in sorted(figures.loads.items()))
        session.say(Reason.of("console.load", loads=loads))
    for sentence in figures.overloads:
        session.say(sentence, Tone.FAULT)
    if not words:
        for line in _drives(session.look_again()):
            session.say(line)
    return ()


def _drives(standing: Standing) -> Iterator[Reason]:
    """Which subsystem drives which world."""
    worlds = {
        subsystem.name: worlds_of(task_of(task.task) for task in subsystem.tasks if task.state != "KILLED")
        for subsystem in standing.subsystems
    }
    return drive_lines(worlds, {world: world in standing.simulated for world in standing.worlds})


def tasks(session: ConsoleSession, words: Words) -> Faults:
    """The living tasks of every subsystem, or of one."""
    rows: list[tuple[Cell, ...]] = [
        (f"{subsystem.name}/{task.task.name}", task.state, task.rtpu, _hz(task.frequency), task.reason)
        for subsystem in session.look_again().subsystems
        for task in subsystem.tasks
        if (not words or subsystem.name == words[0]) and task.state != "KILLED"
    ]
    if rows:
        session.show_table(_TASK_HEAD, rows)
    else:
        session.say(Reason.of("console.no_task_lives"), Tone.DIM)
    return ()


def library(session: ConsoleSession, words: Words) -> Faults:
    """What the search path offers: tasks with what they do, configurations, applications."""
    offered = SiteLibrary(session.site, session.place)
    pattern = words[0] if words else "*"
    configuration, application = Reason.of("console.kind_configuration"), Reason.of("console.kind_application")
    rows: list[tuple[Cell, ...]] = [_task_row(offered, name) for name in fnmatch.filter(offered.tasks, pattern)]
    rows += [(name, configuration, "") for name in fnmatch.filter(offered.configurations, pattern)]
    rows += [(name, application, "") for name in fnmatch.filter(offered.applications, pattern)]
    if rows:
        session.show_table((Reason.of("console.head_name"), "", ""), rows)
    else:
        session.say(Reason.of("console.nothing_called_so"))
    return ()


def _task_row(offered: SiteLibrary, name: str) -> tuple[Cell, ...]:
    task, _ = offered.task(name)
    does = Reason.of("console.file_faulty") if task is None else task.description
    return name, Reason.of("console.kind_task"), does


def subsystems(session: ConsoleSession, words: Words) -> Faults:
    """The subsystems, who holds them and what they run."""
    del words
    present = session.look_again().subsystems
    rows = [_subsystem_row(subsystem, session.subsystem) for subsystem in present]
    if session.subsystem not in {subsystem.name for subsystem in present}:
        moved = Reason.of("console.comes_with_task")
        rows.append(("*", session.subsystem, "0", Reason.of("console.nobody"), moved))
    session.show_table(_SUBSYSTEM_HEAD, rows)
    return ()


def _subsystem_row(subsystem: SubsystemStanding, chosen: str) -> tuple[Cell, ...]:
    mark = "*" if subsystem.name == chosen else ""
    holder = subsystem.holder or Reason.of("console.nobody")
    moved = subsystem.application or Reason.of("console.by_hand")
    return mark, subsystem.name, str(len(subsystem.tasks)), holder, moved


def choose(session: ConsoleSession, words: Words) -> Faults:
    """Choose the subsystem that names without one mean from now on; it need not be there yet."""
    if not words:
        session.say(Reason.plain(session.subsystem))
        return ()
    if not TASK_NAME.match(words[0]):
        return session.no(Reason.of("desk.icon_name", name=words[0]))
    session.subsystem = words[0]
    return ()


def variables(session: ConsoleSession, words: Words) -> Faults:
    """The variables of the subsystem with their types and values, all or those of a pattern."""
    subsystem, pattern = session.address(words[0] if words else "*")
    answer = session.ask(live.Read(subsystem))
    if not isinstance(answer, live.Values):
        return refused(session, Reason.of("console.variables_of", subsystem=subsystem), answer)
    types = types_of(answer)
    names = fnmatch.filter(sorted(answer.values), pattern)
    rows = [(name, types[name], in_a_line(answer.values[name])) for name in names]
    if rows:
        session.show_table(_VARIABLE_HEAD, rows)
    else:
        session.say(Reason.of("console.no_such_variable", subsystem=subsystem))
    return ()


def read(session: ConsoleSession, words: Words) -> Faults:
    """The values of variables now."""
    for word in words:
        subsystem, name = session.address(word)
        current, faults = value(session, subsystem, name)
        if faults:
            return faults
        for line in shown(word, current):
            session.say(Reason.plain(line))
    return ()


def value(session: ConsoleSession, subsystem: str, name: str) -> tuple[Any, Faults]:
    """The value of a variable now, or of an element as in `Q_MEZ[2]`; a fault where there is none."""
    element = _ELEMENT.match(name)
    if element:
        whole, faults = value(session, subsystem, element[1])
        if faults:
            return (None, faults)
        return _element(session, name, whole, element[2])
    answer = session.ask(live.Read(subsystem, (name,)))
    if not isinstance(answer, live.Values):
        return None, refused(session, Reason.of("console.variable_of", name=name, subsystem=subsystem), answer)
    if name not in answer.values:
        return None, session.no(Reason.of("console.no_variable", subsystem=subsystem, name=name))
    return answer.values[name], ()


def check(session: ConsoleSession, words: Words) -> Faults:
    """Check the memory of variables; each finding is a fault (requirement A12)."""
    names = words or tuple(subsystem.name for subsystem in session.look_again().subsystems)
    faults: Faults = ()
    for name in names:
        answer = session.ask(live.Check(name))
        if not isinstance(answer, live.Findings):
            faults += refused(session, Reason.of("console.check_of", name=name), answer)
            continue
        for finding in answer.findings:
            faults += session.no(
                Reason.of("console.unsound_memory", name=name, finding=finding), Reason.of("console.tasks_go_on")
            )
        if not answer.findings:
            session.say(Reason.of("console.sound_memory", name=name), Tone.GOOD)
    return faults


def refused(session: ConsoleSession, expected: Reason, answer: request.Response) -> Faults:
    """The fault of an answer that is not what was asked for."""
    reason = answer.reason if isinstance(answer, request.Refused) else Reason.plain(str(answer))
    return session.no(Reason.of("console.refused", expected=expected, reason=reason))


def _element(session: ConsoleSession, name: str, whole: Any, index: str) -> tuple[Any, Faults]:
    for place in map(int, index.split(",")):
        if not isinstance(whole, list) or place >= len(whole):
            return None, session.no(Reason.of("console.no_element", name=name))
        whole = whole[place]
    return whole, ()


def _hz(frequency: float | None) -> str:
    return "-" if frequency is None else f"{frequency:g}"
