"""The editor: answers what is asked of subsystems by hand: all that is wrong with a change at once, else it begins."""

from collections.abc import Callable, Sequence
from typing import Any

from msgspec import structs

from onika.host import edit
from onika.host.asking import Loading
from onika.host.checks import absent_devices, conflicts, cycles, shapeless, shared_devices, task_of, wrong_rates
from onika.host.forecast import Coming
from onika.host.live import LiveSubsystem, Transaction, placed
from onika.host.preparation import unknown_parameters
from onika.host.stage import Stage
from onika.model.lifecycle import State
from onika.model.rules.reconfiguration import exchange
from onika.runtime import command, news
from onika.runtime.sheet import ModuleSheet, differences
from onika.runtime.wiring import WiredTask, disagreements, wire
from onika.wire import live as asked
from onika.wire import request
from onika.wire.plan import Code, PlannedTask
from onika.words.fault import Fault, Place

Answer = Callable[[request.Response], None]
_INSTEAD = "nothing is changed"


class Editor:
    """One runtime's subsystems as they are held by hand."""

    def __init__(self, stage: Stage, loading: Loading) -> None:
        self._stage = stage
        self._loading = loading
        self._count = 0

    def change(self, order: asked.Change) -> request.Response:
        """Check a change whole; accepted, it begins after those before it."""
        self._loading.expect(order.code)
        living = self._living(order.subsystem)
        sheets, faults = self._sheets(order.code)
        new, wrong, notes = _wired(order.spawn, sheets)
        faults += wrong + _names(order, living)
        faults += [
            Fault(Place(task.place), f"a unit for {task.name} that lives", gone, _INSTEAD)
            for task in order.spawn
            if (gone := self._stage.gone(task.rtpu))
        ]
        kept = [one for one in living if one.name not in order.kill]
        if not faults:
            faults += self._together(order.subsystem, kept, new) + _rates(order, [*kept, *new])
        known, unstated = self._known(order, new)
        faults += unstated
        overloads, near = self._overloads(order, [*kept, *new]) if not faults else ([], [])
        faults += overloads
        if faults:
            return refused(faults, notes)
        live = self._stage.by_hand(order.subsystem)
        live.code |= {code.digest: code for code in order.code}
        live.costs |= {code.digest: self._loading.cost_ns(code) for code in order.code}
        live.known |= known
        comers = tuple((one, self._stage.unit(one.task.rtpu)) for one in new)
        swapped = exchange([placed(one) for one in living], order.kill, [placed(one) for one in new])
        for task, text in near:
            live.warn(task, text)
        what = edit.Edit(swapped, comers, order.off, order.on, order.rates)
        return self._begin(live, edit.change(live, what))

    def reinit(self, order: asked.Reinit) -> request.Response:
        """Initialise a task anew, with other LOCAL lines where they are given."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        wired = None
        if order.local is not None:
            before = live.members[order.task].wired
            wired = WiredTask(structs.replace(before.task, local=order.local), before.sheet, before.ports)
            stated = self._loading.constants(live.code[wired.task.digest], order.local)
            if isinstance(stated, Fault):
                return refused([stated], [])
            live.known[order.task] = _aliased(wired, stated)
        return self._begin(live, edit.reinit(live, order.task, wired))

    def swap(self, order: asked.Swap) -> request.Response:
        """Exchange the code of a living task: its ports stay what they are."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        before = live.members[order.task].wired
        sheet = self._loading.sheet(order.code)
        if isinstance(sheet, Fault):
            return refused([sheet], [])
        planned = structs.replace(before.task, digest=order.code.digest, module=order.code.module)
        faults = differences(task_of(planned), sheet, Place(planned.place))
        if faults:
            return refused(faults, [])
        live.code[order.code.digest] = order.code
        live.costs[order.code.digest] = self._loading.cost_ns(order.code)
        return self._begin(live, edit.swap(live, order.task, wire(planned, sheet)))

    def clear(self, order: asked.Clear) -> request.Response:
        """Bring a task out of ERROR."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        if live.state(order.task) is not State.ERROR:
            return request.Refused(f"{order.task} is {live.state(order.task).value}, not ERROR")
        return self._begin(live, edit.clear(live, order.task))

    def close(self, order: asked.Close) -> request.Response:
        """Kill every task of a subsystem."""
        live = self._stage.live.get(order.subsystem)
        if live is None:
            return request.Refused(f"there is no subsystem {order.subsystem} held by hand")
        return self._begin(live, edit.close(live))

    def answer(self, order: request.Reply) -> request.Response:
        """The user's answer to an asking task."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        if live.state(order.task) is not State.ASKING:
            return request.Refused(f"{order.task} asks for nothing")
        live.send(order.task, command.Answer(order.subsystem, order.task, order.line))
        return request.Done()

    def ask(self, order: asked.Get | asked.Set, answer: Answer) -> None:
        """Ask a module something, or tell it; the answer comes later."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            answer(refusal)
            return

        def told(heard: news.Got | news.Refused) -> None:
            answer(asked.Value(heard.value) if isinstance(heard, news.Got) else request.Refused(heard.reason))

        name = order.name
        to = command.Set if isinstance(order, asked.Set) else command.Get
        words: tuple[Any, ...] = (name, order.value) if isinstance(order, asked.Set) else (name,)
        self._stage.roll.ask(live.members[order.task].rtpu, to(order.subsystem, order.task, *words), told)

    def _begin(self, live: LiveSubsystem, transaction: Transaction) -> asked.Accepted:
        self._count += 1
        live.begin(self._count, transaction)
        return asked.Accepted(self._count)

    def _living(self, subsystem: str) -> list[WiredTask]:
        live = self._stage.live.get(subsystem)
        return live.wired if live is not None else []

    def _task(self, subsystem: str, task: str) -> tuple[LiveSubsystem | None, request.Refused]:
        live = self._stage.live.get(subsystem)
        if live is None or task not in live.members:
            return None, request.Refused(f"there is no task {task} in subsystem {subsystem}")
        return live, request.Refused("")

    def _sheets(self, codes: Sequence[Code]) -> tuple[dict[str, ModuleSheet], list[Fault]]:
        sheets, faults = {}, []
        for code in codes:
            sheet = self._loading.sheet(code)
            if isinstance(sheet, Fault):
                faults.append(sheet)
            else:
                sheets[code.digest] = sheet
        return sheets, faults

    def _together(self, subsystem: str, kept: list[WiredTask], new: list[WiredTask]) -> list[Fault]:
        """What is wrong with these tasks living together, and with devices that others hold."""
        everyone = [*kept, *new]
        faults = disagreements(everyone) + conflicts(everyone) + cycles(everyone)
        others = [one for name, live in self._stage.live.items() if name != subsystem for one in live.wired]
        faults += shared_devices([*others, *everyone]) + absent_devices(new, self._loading)
        return [of_change(fault) for fault in faults]

    def _overloads(self, order: asked.Change, tasks: Sequence[WiredTask]) -> tuple[list[Fault], list[tuple[str, str]]]:
        """Tasks for which a unit has no time, and those for which it hardly has (X13)."""
        by_name = {one.name: one for one in tasks}
        rates = dict(order.rates)
        live = self._stage.live.get(order.subsystem)
        units = {name: member.rtpu for name, member in live.members.items()} if live is not None else {}
        coming = []
        for name in dict.fromkeys((*(turn.task for turn in order.on), *rates)):
            task = by_name[name].task
            hz = rates.get(name) or (live.rates.get(name) if live is not None else None) or task.frequency or 0.0
            rtpu = units.get(name) or self._stage.unit(task.rtpu)
            coming.append(Coming(rtpu, order.subsystem, name, task.digest, hz))
        off = [(order.subsystem, name) for name in (*order.off, *order.kill)]
        found = self._stage.forecast.warnings(off, coming)
        place = Place(f"subsystem {order.subsystem}")
        faults = [
            Fault(place, f"time for {one.task} on {one.rtpu}", text, _INSTEAD) for one, use, text in found if use > 1.0
        ]
        return faults, [(one.task, text) for one, use, text in found if use <= 1.0]

    def _known(self, order: asked.Change, new: Sequence[WiredTask]) -> tuple[dict[str, dict[str, int]], list[Fault]]:
        """What robot modules state of themselves before they live."""
        known: dict[str, dict[str, int]] = {}
        faults = []
        code = {one.digest: one for one in order.code}
        for one in (one for one in new if one.sheet.hardware):
            stated = self._loading.constants(code[one.task.digest], one.task.local)
            if isinstance(stated, Fault):
                faults.append(stated)
            else:
                known[one.name] = _aliased(one, stated)
        together = {name: value for values in known.values() for name, value in values.items()}
        return known, faults + [of_change(fault) for fault in shapeless(new, together)]


def refused(faults: Sequence[Fault], notes: Sequence[str]) -> request.Prepared:
    """All that is wrong, as it travels."""
    texts = (
        request.FaultText(one.place.file, one.place.line, one.expected, one.found, one.instead)
        for one in sorted(set(faults))
    )
    return request.Prepared(tuple(texts), tuple(notes))


def of_change(fault: Fault) -> Fault:
    """A fault of an application's rules, said of a change."""
    return Fault(fault.place, fault.expected, fault.found, _INSTEAD)


def _aliased(wired: WiredTask, stated: dict[str, Any]) -> dict[str, Any]:
    aliases = dict(wired.task.aliases)
    return {aliases.get(name, name): value for name, value in stated.items()}


def _wired(
    tasks: Sequence[PlannedTask], sheets: dict[str, ModuleSheet]
) -> tuple[list[WiredTask], list[Fault], list[str]]:
    wired, faults, notes = [], [], []
    for task in tasks:
        sheet = sheets.get(task.digest)
        if sheet is None:
            continue  # its module's fault is told already
        wrong = differences(task_of(task), sheet, Place(task.place))
        faults += wrong
        notes += unknown_parameters(task, sheet)
        if not wrong:
            wired.append(wire(task, sheet))
    return wired, faults, notes


def _names(order: asked.Change, living: Sequence[WiredTask]) -> list[Fault]:
    """Tasks that are named and are not there, or are there already."""
    there = {one.name for one in living}
    born = [one.name for one in order.spawn]
    after = (there - set(order.kill)) | set(born)
    place = Place(f"subsystem {order.subsystem}")
    missing = [(name, there) for name in order.kill] + [(name, there) for name in order.off]
    missing += [(turn.task, after) for turn in order.on] + [(name, after) for name, _ in order.rates]
    faults = [
        Fault(place, f"one of {', '.join(sorted(known)) or 'no task'}", name, _INSTEAD)
        for name, known in missing
        if name not in known
    ]
    twice = [name for name in dict.fromkeys(born) if born.count(name) > 1 or name in there - set(order.kill)]
    return faults + [Fault(place, "each task once in a subsystem", f"{name} twice", _INSTEAD) for name in twice]


def _rates(order: asked.Change, tasks: Sequence[WiredTask]) -> list[Fault]:
    """Rates that no task can have."""
    place = Place(f"subsystem {order.subsystem}")
    given = [(place, " now", name, hz) for name, hz in order.rates]
    given += [(Place(one.place), "", one.name, one.frequency) for one in order.spawn if one.frequency is not None]
    return wrong_rates(given, {one.name for one in tasks if one.sheet.hardware}, _INSTEAD)
