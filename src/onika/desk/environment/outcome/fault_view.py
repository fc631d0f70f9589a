"""What is wrong with an application, told of its steps and with what could be done about it (E01, X01)."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

from onika.desk.environment.outcome.fault_text import arguments, said, together
from onika.desk.environment.run_state.membership import StepMembership, icons
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import a_kind, kind_named, quoted
from onika.desk.plan.known_worlds import with_worlds
from onika.desk.plan.preparation import PreparedRun
from onika.desk.plan.substitutes import with_substitutes
from onika.desk.plan.world_causes import with_causes
from onika.files import appl, rmod
from onika.model.application import Application, Branch, Hole, Icon, Step, actions
from onika.model.flow_path import StepAddress, flows_by_path, spots
from onika.model.redirect import Redirect
from onika.model.rules.hole import holes
from onika.model.rules.outline import Outline
from onika.model.syntax import Syntax
from onika.store.program import ApplicationProgram
from onika.store.repeated_names import folded
from onika.store.site import Site
from onika.wire import act
from onika.wire.view import FaultView, Remedy, ShowConfiguration, ShowFits, ShowLoop, ShowStep, ShowTarget, ShowValues
from onika.words.cause import FaultGroup, by_cause
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_OF_LOOPS = (
    "rules.loop_at_one_action",
    "rules.loop_condition_misplaced",
    "rules.loop_tag_count",
    "rules.loop_test_count",
    "rules.loop_without_job",
    "rules.loops_cross",
    "rules.loops_share_action",
)
_OF_TAGS = (
    "rules.tag_alone",
    "rules.tag_not_parallel",
    "rules.tags_as_often",
    "rules.tags_as_often_always",
    "rules.tags_in_order",
    "rules.tags_in_order_always",
    "rules.tag_in_endless_loop",
    "rules.tags_too_many",
)
_FITS_HERE = Reason.of("run.fits_here")
_WAYS_ROUND = 2
"""Consequences of which the likeliest remedy is offered beside those of their cause."""
_OF_WHAT_IS_MISSING = ("rules.configuration_missing", "rules.application_missing", "rules.action_missing")


def place_of(opened: OpenApplication) -> Place:
    """What stands for the file of an application in faults and plans."""
    return Place(str(opened.opened.path) if opened.opened is not None else opened.name)


@dataclass(frozen=True, slots=True)
class FaultViews:
    """Of an application that was prepared with the numbers of its steps as lines, in the file `place`."""

    doc: str
    application: Application
    syntax: Syntax
    place: Place
    program: ApplicationProgram | None
    redirects: tuple[Redirect, ...] = ()
    prepared: PreparedRun | None = None
    site: Site | None = None
    """Where substitutes are looked for; None: none are told."""
    _spots: Mapping[int, StepAddress] = field(default_factory=dict)
    _users: Mapping[str, int] = field(default_factory=dict)
    _targets: Mapping[int, tuple[int, ...]] = field(default_factory=dict)
    """Of each action."""

    @classmethod
    def of(
        cls, opened: OpenApplication, syntax: Syntax, prepared: PreparedRun, site: Site | None = None
    ) -> "FaultViews":
        """Those of an open application, that was prepared with its redirections."""
        users: dict[str, int] = {}
        application, program = opened.application, prepared.program
        if program is not None:
            for icon in icons(application):
                _use(icon.onikon.name, icon.number, program, users)
            for one in opened.redirects:
                for name in _named(one.new, program):
                    users.setdefault(name, users.get(one.old, 0))
        known = spots(application), users, StepMembership.of(application, syntax).targets()
        place = place_of(opened)
        return cls(opened.id, application, syntax, place, program, opened.redirects, prepared, site, *known)

    def views(self, prepared: PreparedRun) -> Iterator[FaultView]:
        """Everything that was found, faults first."""
        yield from self._holes()
        yield from self.told(one for one in together(prepared.faults) if not self._is_hole(one))
        yield from self.told(prepared.notes)

    def told(self, faults: Iterable[Fault], *, is_of_runtime: bool = False) -> Iterator[FaultView]:
        """Faults and notes, those of tasks with who could stand for these."""
        every = folded(faults)
        if self.prepared is not None and self.site is not None:
            every = with_causes(with_worlds(every, self.site), self.site)
            every = with_substitutes(every, self.prepared, self.redirects, self.site)
        views: dict[tuple[int, str], FaultView] = {}
        for cause in by_cause(every):
            fault_view = self._view(cause, is_of_runtime=is_of_runtime)
            views.setdefault((fault_view.step, str(fault_view.text)), fault_view)
        yield from views.values()

    def _view(self, cause: FaultGroup, *, is_of_runtime: bool) -> FaultView:
        """A cause, with what follows from it: at its own step, else at the first one of these."""
        together = (cause.fault, *cause.consequences)
        step = next((step for fault in together if (step := self._meant(fault))), 0)
        reason, *follows = (said(self._shown(fault, step)) for fault in together)
        own, *others = ([*self._remedies(fault, step)] for fault in together)
        remedies = tuple(dict.fromkeys((*own, *(ways[0] for ways in others[:_WAYS_ROUND] if ways))))
        level: Literal["fault", "warning"] = "warning" if cause.fault.is_note else "fault"
        return FaultView(reason, level, step, remedies, is_of_runtime, tuple(dict.fromkeys(follows)))

    def step_of(self, place: Place) -> int:
        """The step at which a fault stands, or the first one that uses the file in which it stands; 0: none."""
        if place.file == self.place.file:
            return place.line if place.line in self._spots else 0
        return self._users.get(Path(place.file).name, self._users.get(place.file, 0))

    def target_of(self, action: int, name: str) -> int:
        """The step that is a target of an action, by its name or since there is no other; else the action itself."""
        targets = self._targets.get(action, ())
        named = [one for one in targets if isinstance(icon := self._step(one), Icon) and icon.onikon.name == name]
        meant = named or targets
        return meant[0] if len(meant) == 1 or named else action

    def user_of(self, name: str) -> int:
        """The first step that uses a configuration, a task or an application; 0: none."""
        return self._users.get(name, 0)

    def _meant(self, fault: Fault) -> int:
        step = self.step_of(fault.place)
        is_of_target = self._is_own(fault) and (_is_of_reach(fault) or _is_of_values(fault))
        if is_of_target:
            return self.target_of(step, str(fault.reason.args["target"]))
        return step

    def _is_own(self, fault: Fault) -> bool:
        """Whether it stands in the application itself, and not in one that it uses."""
        return fault.place.file == self.place.file

    def _shown(self, fault: Fault, number: int) -> Fault:
        """A target by what its icon shows, where it is found here by its name."""
        step, name = self._step(number), fault.reason.args.get("target")
        if number == self.step_of(fault.place) or not isinstance(step, Icon) or step.onikon.name != name:
            return fault
        args = {**fault.reason.args, "target": quoted(step.onikon)}
        return replace(fault, reason=Reason.of(fault.reason.key, **args))

    def _is_hole(self, fault: Fault) -> bool:
        step = self._step(self.step_of(fault.place))
        return isinstance(step, Hole) and fault.place.file == self.place.file and not fault.is_note

    def _holes(self) -> Iterator[FaultView]:
        outline = Outline.of(self.application, self.syntax, self.place.file)
        paths = [path for path, _ in flows_by_path(self.application)]
        path_of = {passage.path: path for passage, path in zip(outline.passages, paths, strict=True)}
        for one in holes(outline, self.syntax):
            steps = one.passage.flow.steps
            before = steps[one.position - 1].number if one.position else 0
            show = Remedy(_FITS_HERE, show=ShowFits(path_of[one.passage.path], before))
            wanted = [_new_target(kind) for kind in dict.fromkeys(one.types)]
            yield FaultView(_missing(one.types), "fault", steps[one.position].number, (show, *wanted))

    def _step(self, number: int) -> Step | None:
        spot = self._spots.get(number)
        return spot.step if spot else None

    def _remedies(self, fault: Fault, number: int) -> Iterator[Remedy]:
        """What is obvious, likeliest first; where it stands comes last."""
        step = self._step(number)
        if not fault.is_note:
            yield from self._redirections(fault)
        if isinstance(step, Icon) and not self._is_own(fault) and fault.place.file.endswith(appl.ENDING):
            label = Reason.of("run.open_file", name=Path(fault.place.file).stem)
            yield Remedy(label, act.Open(fault.place.file))
        elif isinstance(step, Icon):
            yield from self._of_icon(fault, step)
        if isinstance(step, Branch) and fault.reason.key == "rules.condition_count":
            yield Remedy(Reason.of("run.its_conditions"), show=ShowStep(number))
        elif not number and fault.reason.key == "rules.flow_empty":
            yield Remedy(_FITS_HERE, show=ShowFits(str(arguments(fault.reason)["number"]), 0))
        elif number:
            yield Remedy(Reason.of("run.show_it"), show=ShowStep(number))

    def _redirections(self, fault: Fault) -> Iterator[Remedy]:
        """Another robot for what this one cannot do: the one that was meant, then the substitutes."""
        file = Path(fault.place.file)
        for one in self.redirects:
            is_of_it = fault.place.file == f"redirect {one}" or file.name == f"{one.new}{rmod.ENDING}"
            is_of_robot = _is_of_reach(fault) or _is_of_company(fault)
            if is_of_it or (_is_of_world(fault, one.new) if one.is_of_world else is_of_robot):
                label = Reason.of("run.let_again", task=one.old.removesuffix(":"))
                yield Remedy(label, act.Redirect(self.doc, one.home, one.old, ""))
        for way in fault.remedies:
            if isinstance(way, Reason) and way.key == "desk.redirect_to":
                old, new = str(way.args["old"]), str(way.args["new"])
                yield Remedy(Reason.of("run.redirect", old=old, new=new), act.Redirect(self.doc, "", old, new))

    def _of_icon(self, fault: Fault, icon: Icon) -> Iterator[Remedy]:
        key, number = fault.reason.key, icon.number
        if key in _OF_LOOPS and icon.while_tag is not None:
            yield Remedy(Reason.of("run.loop_removed"), act.RemoveLoop(self.doc, number))
            yield Remedy(Reason.of("run.mark_anew"), show=ShowLoop(number))
        elif key == "desk.repeats_nothing":
            yield from self._looping(icon)
        elif key in _OF_TAGS and icon.synch_tag is not None:
            yield Remedy(Reason.of("run.tag_removed"), act.SetSynchTag(self.doc, number))
        elif key in ("rules.kind_of_trigger", "rules.kind_unknown"):
            anew = act.ExchangeIcon(self.doc, number, icon.onikon.name)
            yield Remedy(Reason.of("run.exchanged_from_dictionary"), anew)
        elif _is_of_values(fault) or _is_of_reach(fault):
            yield Remedy(Reason.of("run.its_values"), show=ShowValues(number))
        elif key == "rules.target_missing":
            spot = self._spots[number]
            yield Remedy(Reason.of("run.fits_behind"), show=ShowFits(spot.path, number))
        elif key in _OF_WHAT_IS_MISSING:
            yield Remedy(Reason.of("run.remove_it"), act.RemoveIcons(self.doc, (number,)))
        elif self.program is not None and icon.onikon.name in self.program.configurations and not fault.is_note:
            yield Remedy(Reason.of("run.open_configuration"), show=ShowConfiguration(icon.onikon.name))

    def _looping(self, icon: Icon) -> Iterator[Remedy]:
        """The loop that a job was most likely meant to count: over all that stands before it."""
        path = self._spots[icon.number].path
        flow = next((flow for flow_path, flow in flows_by_path(self.application) if flow_path == path), None)
        first = next(iter(actions(flow, self.syntax)), None) if flow is not None else None
        if first is not None and first.icon.number != icon.number and first.icon.while_tag is None:
            yield Remedy(Reason.of("run.repeat_all_before"), act.SetLoop(self.doc, icon.number, first.icon.number))
        yield Remedy(Reason.of("run.mark_loop"), show=ShowLoop(icon.number))


def _new_target(kind: str) -> Remedy:
    return Remedy(Reason.of("run.new_target", kind=kind_named(kind)), show=ShowTarget(kind))


def _missing(types: Sequence[str]) -> Reason:
    """What is missing at a hole: a target of these types, or an action."""
    if not types:
        return Reason.of("run.action_missing_here")
    first, *more = types
    if more:
        kinds = (a_kind(first), *map(kind_named, more))
        return Reason.of("run.kind_missing_here", kind=Reason.of("run.of_either", kinds=kinds))
    return Reason.of("run.kind_missing_here", kind=a_kind(first))


def _is_of_reach(fault: Fault) -> bool:
    """Whether a robot does not come to a target."""
    return fault.reason.key in ("host.unreachable", "host.posture_missing")


def _is_of_company(fault: Fault) -> bool:
    """Whether two robots cannot be used together, whichever of them it stands at."""
    return fault.reason.key in ("host.devices_unfit", "host.device_claimed")


def _is_of_values(fault: Fault) -> bool:
    return fault.reason.key == "host.values_unfit"


def _is_of_world(fault: Fault, world: str) -> bool:
    """Whether it names a world, by the name with its colon, or a device of it."""
    return any(f"{value}:".startswith(world) for value in arguments(fault.reason).values())


def _named(name: str, program: ApplicationProgram) -> list[str]:
    """A task, with the names of its files."""
    task = program.tasks.get(name)
    return [f"{program.task_files.get(name, name)}.rmod", name, *([f"{task.module}.py"] if task else [])]


def _use(name: str, number: int, program: ApplicationProgram, users: dict[str, int]) -> None:
    """Notes which step is the first to use which files, and names of what stands in them."""
    waiting = [name]
    while waiting:
        name = waiting.pop()
        if (configuration := program.configurations.get(name)) is not None or name in program.unread:
            names = [f"{name}.conf", f"{name}.appl", name]
            for placed in configuration.placed if configuration else ():
                names += _named(placed.task, program)
            for one in names:
                users.setdefault(one, number)
        elif (application := program.applications.get(name)) is not None and f"{name}.appl" not in users:
            users[f"{name}.appl"] = users[name] = number
            waiting += [icon.onikon.name for icon in icons(application)]
