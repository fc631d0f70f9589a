"""Compiling: a program found on a site becomes the plan that a runtime executes (house decision 2, §5.9.2)."""

from hashlib import sha256

from onika.files import text
from onika.model.application import AppFlow, Icon, actions
from onika.model.configuration import Configuration
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.program import Program
from onika.wire.plan import Code, Plan, PlannedAction, PlannedFlow, PlannedTask
from onika.wire.request import TargetValues
from onika.words.fault import Fault, Place
from onika.words.value import Value

UNKNOWN = "unknown"


class Compiler:
    """Compiles what is there; faults name what is not. `places` gives the `.rmod` file of a task."""

    def __init__(self, program: Program, syntax: Syntax, place: Place, places: dict[str, str]) -> None:
        self._program = program
        self._syntax = syntax
        self._place = place
        self._places = places
        self._digests: dict[str, str] = {}
        self.faults: list[Fault] = []
        self.targets: list[TargetValues] = []

    def plan(self) -> Plan:
        """The plan of everything that could be compiled."""
        code = self._code()
        application = self._program.application
        flows = application.flows if application.is_parallel else application.flows[:1]
        return Plan(application.name, tuple(self._flow(n, flow) for n, flow in enumerate(flows)), code)

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

    def _flow(self, number: int, flow: AppFlow) -> PlannedFlow:
        planned: list[PlannedAction] = []
        tasks: dict[str, PlannedTask] = {}
        for position, job, targets in actions(flow, self._syntax):
            target = next((one for one in targets if isinstance(one, Icon)), None)
            configuration = self._program.configurations.get(job.onikon.name)
            if configuration is None:
                continue  # a no-op takes no time; whatever else is missing is a fault of readiness
            present = [one for one in configuration.placed if one.task in self._program.tasks]
            for one in present:
                task = self._program.tasks[one.task]
                if task.module in self._digests:
                    tasks.setdefault(one.task, self._task(task, one.rtpu))
            index = len(planned)
            planned.append(self._action(number, position, job, target, configuration, set(tasks)))
            if target is not None:
                kind = target.onikon.type.lower()
                self.targets.append(TargetValues(number, index, kind, _flat(target.onikon.values)))
        return PlannedFlow(f"flow{number}", tuple(tasks.values()), tuple(planned))

    def _action(
        self,
        number: int,
        position: int,
        job: Icon,
        target: Icon | None,
        configuration: Configuration,
        tasks: set[str],
    ) -> PlannedAction:
        name = job.onikon.name if target is None else f"{job.onikon.name} {target.onikon.name}"
        present = [one for one in configuration.placed if one.task in tasks]
        arguments = "" if target is None else target.onikon.argument_line(self._syntax)
        return PlannedAction(
            name=name,
            job=job.onikon.name,
            target=None if target is None else target.onikon.name,
            place=self._place.file,
            line=job.line,
            lacks_tasks=len(present) < len(configuration.placed),
            tasks=tuple(one.task for one in present),
            rates=tuple((one.task, one.frequency) for one in present if one.frequency and self._keeps_time(one.task)),
            arguments=arguments,
            marker=job.marker or (target is not None and target.marker),
            synch_tag=job.synch_tag or (target.synch_tag if target is not None else None),
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
