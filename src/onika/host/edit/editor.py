"""The editor: answers what is asked of subsystems by hand: all that is wrong with a change at once, else it begins."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any

from msgspec import structs

from onika.host.edit import edit_objections, failed_writers, hand_writing, tight_units, transactions
from onika.host.loading.module_questions import ModuleQuestions
from onika.host.loading.plan_checks import (
    absent_devices,
    conflicts,
    cycles,
    shapeless,
    shared_devices,
    states_constants,
)
from onika.host.loading.plan_form import wrong_code, wrong_tasks, wrong_worlds
from onika.host.loading.plan_preparation import unknown_parameters
from onika.host.subsystems.live_subsystem import LiveSubsystem, Transaction
from onika.host.subsystems.load_forecast import ComingTask
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.model.lifecycle import State
from onika.model.planned import task_of
from onika.model.rules.reconfiguration import exchange
from onika.runtime import command, news
from onika.runtime.modules.sheet import differences
from onika.runtime.wiring import WiredTask, disagreements, wire
from onika.wire import live as asked, request
from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

Answer = Callable[[request.Response], None]


class LiveEditor:
    """One runtime's subsystems as they are held by hand."""

    def __init__(self, subsystems: Subsystems, loading: ModuleQuestions) -> None:
        self._subsystems = subsystems
        self._loading = loading
        self._count = 0

    def change(self, order: asked.Change) -> request.Response:
        """Check a change whole; accepted, it begins after those before it."""
        malformed = wrong_code(order.code) + wrong_worlds(order.worlds)
        malformed += wrong_tasks(order.spawn, [code.digest for code in order.code])
        if malformed:
            return refused([edit_objections.of_change(fault) for fault in malformed], [])
        self._loading.offer(order.worlds)
        self._loading.expect(order.code)
        sheets, faults = self._sheets(order.code)
        new, wrong, notes = edit_objections.wired(order.spawn, sheets)
        faults += wrong + [edit_objections.of_change(fault) for fault in absent_devices(new, self._loading)]
        constants, unstated = self._known(order, new)
        faults += unstated
        live = self._subsystems.live.get(order.subsystem)
        is_next = live is None or not live.is_busy  # else it finds what those before it leave
        if is_next:
            faults += self._faults(order, new, bool(faults))
        if faults:
            return refused(faults, notes)
        live = self._subsystems.by_hand(order.subsystem)
        for code in order.code:
            live.executor.spawner.add_code(code, self._loading.cost_ns(code))
        return self._begin(live, self._carry_out(live, order, new, constants, is_next))

    def _carry_out(
        self,
        live: LiveSubsystem,
        order: asked.Change,
        new: list[WiredTask],
        constants: dict[str, dict[str, int]],
        is_checked: bool,
    ) -> Transaction:
        """A change when its turn has come; one that had to wait is checked then."""
        faults = [] if is_checked else self._faults(order, new, False)
        if faults:
            return Reason.of("host.several", reasons=tuple(fault.reason for fault in faults))
        kept = [wired_task for wired_task in live.wired if wired_task.name not in order.kill]
        for task, text in self._overloads(order, [*kept, *new])[1]:
            live.warn(task, text)
        comers = tuple((wired_task, self._subsystems.unit(wired_task.task.rtpu)) for wired_task in new)
        spare = {task.name: self._subsystems.spare_units(task.task.rtpu) for task in new if not task.sheet.hardware}
        latitude = self._latitude(order.subsystem, order.holds, spare)
        swapped = exchange(
            [wired_task.placed for wired_task in live.wired], order.kill, [wired_task.placed for wired_task in new]
        )
        return (
            yield from transactions.change(
                live, transactions.Edit(swapped, comers, order.off, order.on, order.rates, constants, latitude)
            )
        )

    def reinit(self, order: asked.Reinit) -> request.Response:
        """Initialise a task anew, with other LOCAL lines where they are given."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        before, wired, stated = live.members[order.task].wired, None, None
        if order.local is not None:
            planned = structs.replace(before.task, local=order.local)
            wired = WiredTask(planned, before.sheet, before.ports)
            faults = differences(task_of(planned), before.sheet, Place(planned.place)) + edit_objections.moved(
                before, wired
            )
            if faults:
                return refused(
                    [edit_objections.of_change(fault) for fault in faults], unknown_parameters(planned, before.sheet)
                )
            constants = self._loading.constants(live.executor.spawner.code(planned.digest), order.local)
            if isinstance(constants, Fault):
                return refused([edit_objections.of_change(constants)], [])
            stated = _aliased(wired, constants)
        return self._begin(live, _still(live, before, transactions.reinitialise(live, order.task, wired, stated)))

    def swap(self, order: asked.Swap) -> request.Response:
        """Exchange the code of a living task: its ports stay what they are."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        before = live.members[order.task].wired
        malformed = wrong_code([order.code])
        if malformed:
            return refused([edit_objections.of_change(fault) for fault in malformed], [])
        sheet = self._loading.sheet(order.code)
        if isinstance(sheet, Fault):
            return refused([edit_objections.of_change(sheet)], [])
        planned = structs.replace(before.task, digest=order.code.digest, module=order.code.module)
        faults = differences(task_of(planned), sheet, Place(planned.place))
        wired = wire(planned, sheet) if not faults else before
        faults += edit_objections.grown(before, wired) + conflicts(
            [wired if other is before else other for other in live.wired]
        )
        if faults:
            return refused([edit_objections.of_change(fault) for fault in faults], unknown_parameters(planned, sheet))
        live.executor.spawner.add_code(order.code, self._loading.cost_ns(order.code))
        latitude = self._latitude(order.subsystem, order.holds)
        return self._begin(live, _still(live, before, transactions.swap(live, order.task, wired, latitude)))

    def clear(self, order: asked.Clear) -> request.Response:
        """Bring a task out of ERROR."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        if live.state(order.task) is not State.ERROR:
            return request.Refused(Reason.of("host.not_in_error", task=order.task, state=live.state(order.task).value))
        objection = NOTHING if live.is_busy else failed_writers.objection_to_clear(live, order.task)
        if objection:
            return request.Refused(objection)
        wired = live.members[order.task].wired
        return self._begin(live, _still(live, wired, transactions.clearing(live, order.task)))

    def write(self, order: asked.Write) -> request.Response:
        """Write a variable that nobody writes."""
        live = self._subsystems.live.get(order.subsystem)
        if live is None:
            return request.Refused(Reason.of("host.not_by_hand", subsystem=order.subsystem))
        return hand_writing.write(live, order)

    def close(self, order: asked.Close) -> request.Response:
        """Kill every task of a subsystem."""
        live = self._subsystems.live.get(order.subsystem)
        if live is None:
            return request.Refused(Reason.of("host.not_by_hand", subsystem=order.subsystem))
        return self._begin(live, transactions.close(live))

    def answer(self, order: request.Reply) -> request.Response:
        """The user's answer to an asking task."""
        live, refusal = self._task(order.subsystem, order.task)
        if live is None:
            return refusal
        if live.state(order.task) is not State.ASKING:
            return request.Refused(Reason.of("host.asks_nothing", task=order.task))
        live.answer(order.task, order.line)
        return request.Done()

    def ask(self, order: asked.Get | asked.Set, answer: Answer) -> None:
        """Ask a module something, or tell it; the answer comes later."""
        member = self._subsystems.members(order.subsystem).get(order.task)
        if member is None:
            answer(request.Refused(Reason.of("host.no_such_task", task=order.task, subsystem=order.subsystem)))
            return

        def take_answer(message: news.Got | news.Refused) -> None:
            answer(asked.Value(message.value) if isinstance(message, news.Got) else request.Refused(message.reason))

        name = order.name
        to = command.Set if isinstance(order, asked.Set) else command.Get
        words: tuple[Any, ...] = (name, order.value) if isinstance(order, asked.Set) else (name,)
        self._subsystems.status_poll.ask(member.rtpu, to(order.subsystem, order.task, *words), take_answer)

    def _begin(self, live: LiveSubsystem, transaction: Transaction) -> asked.Accepted:
        self._count += 1
        live.begin(self._count, transaction)
        return asked.Accepted(self._count)

    def _latitude(
        self, subsystem: str, holds: bool, spare: Mapping[str, tuple[str, ...]] = MappingProxyType({})
    ) -> tight_units.Latitude:
        return tight_units.Latitude(spare, partial(self._subsystems.is_driven, by=subsystem), holds)

    def _living(self, subsystem: str) -> list[WiredTask]:
        live = self._subsystems.live.get(subsystem)
        return live.wired if live is not None else []

    def _task(self, subsystem: str, task: str) -> tuple[LiveSubsystem | None, request.Refused]:
        live = self._subsystems.live.get(subsystem)
        if live is None or live.state(task) is State.KILLED:  # never born, dead, or gone with its unit
            return None, request.Refused(Reason.of("host.no_such_task", task=task, subsystem=subsystem))
        return live, request.Refused(NOTHING)

    def _sheets(self, codes: Sequence[Code]) -> tuple[dict[str, ModuleSheet], list[Fault]]:
        sheets, faults = {}, []
        for code in codes:
            sheet = self._loading.sheet(code)
            if isinstance(sheet, Fault):
                faults.append(sheet)
            else:
                sheets[code.digest] = sheet
        return sheets, faults

    def _faults(self, order: asked.Change, new: list[WiredTask], is_wrong: bool) -> list[Fault]:
        """All that is wrong with a change as things stand; where more is wrong already, only what is plain."""
        living = self._living(order.subsystem)
        faults = edit_objections.names(order, living)
        faults += [
            Fault(
                Place(wired_task.task.place),
                Reason.of("host.unit_gone", name=wired_task.name, gone=gone),
                edit_objections.INSTEAD,
            )
            for wired_task in new
            if (gone := self._subsystems.gone(wired_task.task.rtpu))
        ]
        everyone = [*(wired_task for wired_task in living if wired_task.name not in order.kill), *new]
        if not (faults or is_wrong):
            faults += self._together(order.subsystem, everyone) + edit_objections.rates(order, everyone)
        return faults or ([] if is_wrong else self._overloads(order, everyone)[0])

    def _together(self, subsystem: str, everyone: list[WiredTask]) -> list[Fault]:
        """What is wrong with these tasks living together, and with devices that others hold."""
        faults = disagreements(everyone) + conflicts(everyone) + cycles(everyone)
        others = [
            wired_task for name, live in self._subsystems.live.items() if name != subsystem for wired_task in live.wired
        ]
        return [edit_objections.of_change(fault) for fault in faults + shared_devices([*others, *everyone])]

    def _overloads(
        self, order: asked.Change, tasks: Sequence[WiredTask]
    ) -> tuple[list[Fault], list[tuple[str, Reason]]]:
        """Tasks for which a unit has no time, and those for which it hardly has (X13)."""
        by_name = {task.name: task for task in tasks}
        rates = dict(order.rates)
        live = self._subsystems.live.get(order.subsystem)
        units = {name: member.rtpu for name, member in live.members.items()} if live is not None else {}
        coming = []
        for name in dict.fromkeys((*(turn.task for turn in order.on), *rates)):
            task = by_name[name].task
            hz = rates.get(name) or (live.desired.rate(name) if live is not None else None) or task.frequency or 0.0
            rtpu = units.get(name) or self._subsystems.unit(task.rtpu)
            coming.append(ComingTask(rtpu, order.subsystem, name, task.digest, hz))
        off = [(order.subsystem, name) for name in (*order.off, *order.kill)]
        warnings = self._subsystems.forecast.warnings(off, coming)
        place = Place(f"subsystem {order.subsystem}")
        faults = [
            Fault(
                place, Reason.of("host.no_time", task=coming.task, rtpu=coming.rtpu, text=text), edit_objections.INSTEAD
            )
            for coming, use, text in warnings
            if use > 1.0
        ]
        return faults, [(coming.task, text) for coming, use, text in warnings if use <= 1.0]

    def _known(self, order: asked.Change, new: Sequence[WiredTask]) -> tuple[dict[str, dict[str, int]], list[Fault]]:
        """What robot modules state of themselves before they live."""
        constants: dict[str, dict[str, int]] = {}
        faults = []
        code = {code.digest: code for code in order.code}
        for wired_task in filter(states_constants, new):
            stated = self._loading.constants(code[wired_task.task.digest], wired_task.task.local)
            if isinstance(stated, Fault):
                faults.append(stated)
            else:
                constants[wired_task.name] = _aliased(wired_task, stated)
        together = {name: value for values in constants.values() for name, value in values.items()}
        return constants, faults + [edit_objections.of_change(fault) for fault in shapeless(new, together)]


def refused(faults: Sequence[Fault], notes: Sequence[Reason]) -> request.Prepared:
    """All that is wrong, as it travels."""
    return request.Prepared(tuple(map(request.FaultText.of, sorted(set(faults)))), tuple(notes))


def _aliased(wired: WiredTask, stated: dict[str, Any]) -> dict[str, Any]:
    aliases = dict(wired.task.aliases)
    return {aliases.get(name, name): value for name, value in stated.items()}


def _still(live: LiveSubsystem, wired: WiredTask, transaction: Transaction) -> Transaction:
    """A transaction about a task as it was checked, if it still is when its turn comes."""
    member = live.members.get(wired.name)
    if member is None or member.wired is not wired:
        return Reason.of("host.of_task", task=wired.name, why=Reason.of("host.changed_meanwhile"))
    return (yield from transaction)
