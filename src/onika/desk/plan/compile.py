"""The compiler: turns an application, with all that it needs, into the plan that a runtime executes (§5.9.2)."""

from collections.abc import Callable, Iterator, Mapping, Sequence

from onika.desk.plan.module_code import module_code
from onika.desk.plan.sequence import FlowSequence, SequencedAction, Sequencer, plain_type
from onika.files import text
from onika.model.application import Icon
from onika.model.configuration import Placed
from onika.model.redirect import Choice, Redirect, choice, world_choice
from onika.model.rules.redirection import redirected
from onika.model.rules.worlds import relocated, worlds_of
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.opened_text import Faults
from onika.store.program import ApplicationProgram
from onika.wire.plan import Code, Plan, PlannedAction, PlannedFlow, PlannedTask
from onika.wire.request import TargetValues
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of
from onika.words.value import Value

UNKNOWN = "unknown"


def _no_files(_world: str) -> tuple[WorldSource | None, Faults]:
    return None, ()


class Compiler:
    """Compiles what is there; faults name what is not.

    places      the `.rmod` files of the tasks
    file_of     the file of a nested application
    redirects   the tasks that stand for others
    worlds      the files of a world, where it is made of some, and what is wrong with them
    """

    def __init__(
        self,
        program: ApplicationProgram,
        syntax: Syntax,
        place: Place,
        places: Mapping[str, str],
        file_of: Callable[[str], str] = lambda name: f"{name}.appl",
        redirects: Sequence[Redirect] = (),
        worlds: Callable[[str], tuple[WorldSource | None, Faults]] = _no_files,
    ) -> None:
        self._worlds = worlds
        self._program = program
        self._syntax = syntax
        self._place = place
        self._places = places
        self._file_of = file_of
        self._redirects = redirects
        self._digests: dict[str, str] = {}
        self._codeless: dict[str, list[str]] = {}
        """The tasks of modules without code, by these modules; told of those that are to live."""
        self._wanted: set[str] = set()
        self.faults: list[Fault] = []
        self.targets: list[TargetValues] = []

    def plan(self) -> Plan:
        """The plan of everything that could be compiled."""
        code = self._code()
        sequencer = Sequencer(self._syntax, self._program.applications, self._file_of)
        lines = sequencer.sequence(self._program.application, self._place.file)
        flows = tuple(self._flow(n, line) for n, line in enumerate(lines))
        self.faults += [
            no_code(module, self._places.get(name, name))
            for module, users in self._codeless.items()
            for name in users
            if name in self._wanted
        ]
        return Plan(self._program.application.name, flows, code, self._files_of_worlds(flows))

    def _files_of_worlds(self, flows: Sequence[PlannedFlow]) -> tuple[WorldSource, ...]:
        """Of the worlds that are driven."""
        gathered = []
        for world in sorted({driven.partition("@")[0] for flow in flows for _, driven in flow.worlds}):
            files, faults = self._worlds(world)
            self.faults += faults
            gathered += [files] if files is not None else []
        return tuple(gathered)

    def _code(self) -> tuple[Code, ...]:
        codes = []
        for module in sorted({task.module for task in self._program.tasks.values()}):
            path = self._program.code.get(module)
            if path is None:
                users = {task.name for task in self._program.tasks.values() if task.module == module}
                self._codeless[module] = sorted(users)
                continue
            source, faults = text.load(path, str(path))
            self.faults += faults
            if source is None:
                continue
            code = module_code(module, path, source)
            self._digests[module] = code.digest
            codes.append(code)
        return tuple(codes)

    def _flow(self, number: int, line: FlowSequence) -> PlannedFlow:
        tasks: dict[str, PlannedTask] = {}
        actions: list[PlannedAction] = []
        chosen = choice(self._redirects, line.subsystem)
        worlds = world_choice(self._redirects, line.subsystem)
        crews = {
            name: redirected(configuration, chosen, self._program.tasks)
            for name, configuration in self._program.configurations.items()
        }
        replaced: dict[str, PlannedTask] = {}
        for index, doing in enumerate(line.doings):
            configuration = crews.get(doing.icon.onikon.name)
            placed = () if configuration is None or doing.is_noop else configuration.placed
            if chosen:
                replaced.update(self._replaced(doing.icon.onikon.name, chosen))
            for member in placed:
                self._wanted.add(member.task)
                task = self._program.tasks.get(member.task)
                if task is not None and member.task not in tasks and task.module in self._digests:
                    tasks[member.task] = self._task(relocated(task, worlds), member.rtpu)
            actions.append(self._action(doing, placed, tasks))
            for target in doing.targets:
                kind = plain_type(target.onikon.type)
                values, name = _flat(target.onikon.values), target.onikon.name
                self.targets.append(TargetValues(number, index, kind, values, name))
        living, program = tuple(tasks.values()), tuple(line.program)
        replacements = tuple((name, old) for name, old in replaced.items() if name in tasks)
        named = worlds_of(self._program.tasks[name] for name in tasks)
        driven = tuple((world, worlds.get(world, world)) for world in named)
        return PlannedFlow(line.subsystem, living, tuple(actions), program, line.parent, replacements, driven)

    def _replaced(self, job: str, chosen: Choice) -> Iterator[tuple[str, PlannedTask]]:
        """The tasks of a job that others stand for, by the names of these; without a digest where they have no code."""
        configuration = self._program.configurations.get(job)
        for placed in configuration.placed if configuration is not None else ():
            task = self._program.tasks.get(placed.task)
            if task is not None and chosen.get(task.name) in self._program.tasks:
                place = self._places.get(task.name, task.name)
                yield chosen[task.name], planned_task(task, placed.rtpu, self._digests.get(task.module, ""), place)

    def _action(
        self, doing: SequencedAction, placed: Sequence[Placed], tasks: Mapping[str, PlannedTask]
    ) -> PlannedAction:
        job = doing.icon.onikon
        names = [target.onikon.name for target in doing.targets]
        present = [placed for placed in placed if placed.task in tasks]
        return PlannedAction(
            name=" ".join((job.name, *names)),
            job=job.name,
            target=" ".join(names) or None,
            place=doing.file,
            line=doing.icon.line,
            lacks_tasks=not doing.is_noop and (len(present) < len(placed) or not placed),
            tasks=tuple(placed.task for placed in present),
            rates=tuple(
                (placed.task, placed.frequency)
                for placed in present
                if placed.frequency and self._keeps_time(placed.task)
            ),
            arguments=" ".join(map(self._arguments, doing.targets)),
            marker=doing.icon.marker,
            synch_tag=doing.icon.synch_tag,
            is_noop=doing.is_noop,
            within=doing.within,
            spot=doing.spot,
        )

    def _arguments(self, target: Icon) -> str:
        try:
            return target.onikon.argument_line(self._syntax)
        except ValueError as wrong:  # the definition of its type has changed since it was made
            place = Place(self._place.file, target.line)
            self.faults.append(Fault(place, reason_of(wrong), Reason.of("words.application_not_run")))
            return ""

    def _keeps_time(self, name: str) -> bool:
        return self._program.tasks[name].frequency is not None

    def _task(self, task: Task, rtpu: str) -> PlannedTask:
        return planned_task(task, rtpu, self._digests[task.module], self._places.get(task.name, task.name))


def no_code(module: str, place: str) -> Fault:
    """The fault of a task, whose file is `place`, that has no code."""
    return Fault(Place(place), Reason.of("desk.code_missing", module=module), Reason.of("desk.task_left_out"))


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
    return tuple(number for item in values for number in item)
