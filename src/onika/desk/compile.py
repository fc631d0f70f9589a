"""Compiling: a program found on a site becomes the plan that a runtime executes (house decision 2, §5.9.2)."""

from collections.abc import Callable, Mapping, Sequence
from hashlib import sha256

from onika.desk.sequence import Doing, Line, Sequencer, plain_type
from onika.files import text
from onika.model.configuration import Placed
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.program import Program
from onika.wire.plan import Code, Plan, PlannedAction, PlannedFlow, PlannedTask
from onika.wire.request import TargetValues
from onika.words.fault import Fault, Place
from onika.words.value import Value

UNKNOWN = "unknown"


class Compiler:
    """Compiles what is there; faults name what is not.

    places      the `.rmod` files of the tasks
    file_of     the file of a nested application
    """

    def __init__(
        self,
        program: Program,
        syntax: Syntax,
        place: Place,
        places: Mapping[str, str],
        file_of: Callable[[str], str] = lambda name: f"{name}.appl",
    ) -> None:
        self._program = program
        self._syntax = syntax
        self._place = place
        self._places = places
        self._file_of = file_of
        self._digests: dict[str, str] = {}
        self.faults: list[Fault] = []
        self.targets: list[TargetValues] = []

    def plan(self) -> Plan:
        """The plan of everything that could be compiled."""
        code = self._code()
        sequencer = Sequencer(self._syntax, self._program.applications, self._file_of)
        lines = sequencer.sequence(self._program.application, self._place.file)
        return Plan(self._program.application.name, tuple(self._flow(n, line) for n, line in enumerate(lines)), code)

    def _code(self) -> tuple[Code, ...]:
        found = []
        for module in sorted({task.module for task in self._program.tasks.values()}):
            path = self._program.code.get(module)
            if path is None:
                users = sorted(task.name for task in self._program.tasks.values() if task.module == module)
                self.faults += [no_code(module, self._places.get(name, name)) for name in users]
                continue
            source, faults = text.load(path, str(path))
            self.faults += faults
            if source is None:
                continue
            digest = sha256(source.encode()).hexdigest()
            self._digests[module] = digest
            found.append(Code(digest, module, str(path), source))
        return tuple(found)

    def _flow(self, number: int, line: Line) -> PlannedFlow:
        tasks: dict[str, PlannedTask] = {}
        actions: list[PlannedAction] = []
        for index, doing in enumerate(line.doings):
            configuration = self._program.configurations.get(doing.icon.onikon.name)
            placed = () if configuration is None or doing.is_noop else configuration.placed
            for one in placed:
                task = self._program.tasks.get(one.task)
                if task is not None and one.task not in tasks and task.module in self._digests:
                    tasks[one.task] = self._task(task, one.rtpu)
            actions.append(self._action(doing, placed, tasks))
            for target in doing.targets:
                kind = plain_type(target.onikon.type)
                self.targets.append(TargetValues(number, index, kind, _flat(target.onikon.values)))
        return PlannedFlow(line.subsystem, tuple(tasks.values()), tuple(actions), tuple(line.program), line.parent)

    def _action(self, doing: Doing, placed: Sequence[Placed], tasks: Mapping[str, PlannedTask]) -> PlannedAction:
        job = doing.icon.onikon
        names = [target.onikon.name for target in doing.targets]
        present = [one for one in placed if one.task in tasks]
        return PlannedAction(
            name=" ".join((job.name, *names)),
            job=job.name,
            target=" ".join(names) or None,
            place=doing.file,
            line=doing.icon.line,
            lacks_tasks=not doing.is_noop and (len(present) < len(placed) or not placed),
            tasks=tuple(one.task for one in present),
            rates=tuple((one.task, one.frequency) for one in present if one.frequency and self._keeps_time(one.task)),
            arguments=" ".join(target.onikon.argument_line(self._syntax) for target in doing.targets),
            marker=doing.icon.marker,
            synch_tag=doing.icon.synch_tag,
            is_noop=doing.is_noop,
            within=doing.within,
        )

    def _keeps_time(self, name: str) -> bool:
        return self._program.tasks[name].frequency is not None

    def _task(self, task: Task, rtpu: str) -> PlannedTask:
        return planned_task(task, rtpu, self._digests[task.module], self._places.get(task.name, task.name))


def no_code(module: str, place: str) -> Fault:
    """The fault of a task, whose file is `place`, that has no code."""
    expected = f"{module}.py beside it or on the search path, as MODULE says"
    return Fault(Place(place), expected, "none", "the task is left out")


def planned_task(task: Task, rtpu: str, digest: str, place: str) -> PlannedTask:
    """A task as a plan carries it."""
    return PlannedTask(
        name=task.name,
        module=task.module,
        digest=digest,
        place=place,
        rtpu=rtpu,
        frequency=task.frequency,
        type=task.type.value,
        aliases=task.aliases,
        inconst=task.inconst,
        outconst=task.outconst,
        invar=task.invar,
        outvar=task.outvar,
        local=tuple((line.key, line.words) for line in task.local),
    )


def rtpus_of(plan: Plan) -> tuple[str, ...]:
    """The processing units a plan names, in order; one called rt0 where it names none."""
    named = {task.rtpu for flow in plan.flows for task in flow.tasks if task.rtpu != UNKNOWN}
    return tuple(sorted(named)) or ("rt0",)


def _flat(values: tuple[tuple[Value, ...], ...]) -> tuple[Value, ...]:
    return tuple(one for item in values for one in item)
