"""A fault of an application in the words of whoever builds it from pictures, without lines, files and step numbers."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from onika.desk.plan.icon_names import kind_named
from onika.words.catalogue import sentence
from onika.words.fault import Fault, Place
from onika.words.reason import Argument, Reason
from onika.words.sentence import gaps

_OF_WORKCELLS = (".mjcf", ".robot", ".urdf", ".world", ".xml")
_SENTENCES = {
    "desk.icon_twice": "run.name_twice",
    "desk.task_not_of_flow": "run.not_used",
    "desk.task_unknown": "run.no_new_task",
    "host.device_claimed": "run.device_claimed",
    "host.device_unlike": "run.device_unlike",
    "host.module_twice": "run.module_used",
    "host.no_such_device": "run.no_device",
    "host.no_world_of_device": "run.no_world",
    "host.poses_unknown": "run.nothing_known",
    "host.posture_missing": "run.posture_missing",
    "host.postures_unknown": "run.nothing_known",
    "host.trigger_missing": "run.no_trigger",
    "host.unreachable": "run.unreachable",
    "host.values_unfit": "run.values_unfit",
    "rules.action_missing": "run.action_missing",
    "rules.application_circle": "run.circle",
    "rules.application_missing": "run.no_application",
    "desk.repeats_nothing": "run.repeats_nothing",
    "rules.condition_count": "run.condition_count",
    "rules.condition_flow": "run.condition_variable",
    "rules.condition_form": "run.condition_none",
    "rules.condition_variable": "run.condition_variable",
    "rules.configuration_missing": "run.no_configuration",
    "rules.constant_missing": "run.no_constant",
    "rules.constant_twice": "run.constants_shared",
    "rules.device_twice": "run.device_shared",
    "rules.edges_unfit": "run.edges_unfit",
    "rules.end_unfit": "run.end_unfit",
    "rules.flow_empty": "run.flow_empty",
    "rules.hanging": "run.hanging",
    "rules.holes_undefined": "rules.holes_undefined",
    "rules.holes_untyped": "rules.holes_untyped",
    "rules.holes_untyped_wholly": "rules.holes_untyped_wholly",
    "rules.kind_of_trigger": "run.kind_of_trigger",
    "rules.kind_unknown": "run.kind_unknown",
    "rules.loop_at_one_action": "run.loop_at_one_action",
    "rules.loop_condition_misplaced": "run.loop_condition",
    "rules.loop_tag_count": "run.loop_marked",
    "rules.loop_test_count": "run.loop_tests",
    "rules.loop_without_job": "run.loop_without_job",
    "rules.loops_cross": "run.loops_cross",
    "rules.loops_share_action": "run.loops_shared",
    "rules.module_twice": "run.module_shared",
    "rules.no_flow": "run.no_flow",
    "rules.start_unfit": "run.start_unfit",
    "rules.tag_alone": "run.tag_alone",
    "rules.tag_not_parallel": "run.tag_not_parallel",
    "rules.target_missing": "run.target_missing",
    "rules.target_undefined": "rules.target_undefined",
    "rules.task_in": "run.task_in",
    "rules.task_in_flow": "run.task_in",
    "rules.icon_of_kind": "run.icon_of_kind",
    "rules.task_missing": "run.no_task",
    "runtime.constant_missing": "run.no_supplier",
    "runtime.device_missing": "run.no_device_line",
    "runtime.local_missing": "run.no_local",
    "runtime.port_undeclared": "run.no_port",
    "store.name_twice": "run.name_twice",
    "store.names_twice": "run.names_twice",
}
"""Of a reason, by its key, the sentence that says it without places and files' names of types, with its arguments."""

_WHY = {"desk.substitute_unfit": "reason", "host.devices_unfit": "why", "runtime.local_unfit": "why"}
"""Reasons of which one argument says it all."""

_KINDS = ("kind", "wanted")
_NOT_DONE = ("words.application_not_run", "words.nothing_run")


def said(fault: Fault) -> Reason:
    """A fault as a sentence; what is wrong with a file of a workcell, with file and line, for nothing else shows it."""
    place = fault.place
    if place.file.endswith(_OF_WORKCELLS):
        return Reason.of("run.what_why", what=str(Place(Path(place.file).name, place.line)), why=_plain(fault))
    return _plain(fault)


def _plain(fault: Fault) -> Reason:
    reason = _special(fault.reason) or simple(fault.reason)
    if reason is not fault.reason:
        return reason
    if fault.instead.key in _NOT_DONE or not fault.instead:
        return fault.reason
    return Reason.of("run.fault_instead", reason=fault.reason, instead=fault.instead)


def simple(reason: Reason) -> Reason:
    """The reason without places, where there is such a sentence; else as it is."""
    if reason.key == "rules.icon":
        return Reason.plain(str(reason.args["name"]))
    key = _SENTENCES.get(reason.key)
    if key is None:
        return reason
    return _made(key, arguments(reason))


def arguments(reason: Reason) -> dict[str, Argument]:
    """The arguments of a reason, and those of the reasons among them; where names are the same, the outer ones."""
    every = dict(reason.args)
    for value in reason.args.values():
        if isinstance(value, Reason):
            every = arguments(value) | every
    return every


def together(faults: Iterable[Fault]) -> list[Fault]:
    """What two tasks have in common, told once with all of it: two arms in one flow share all their constants."""
    merged: dict[object, Fault] = {}
    for fault in faults:
        args = fault.reason.args
        is_shared = fault.reason.key == "rules.constant_twice"
        key = (fault.place, args["tasks"]) if is_shared else fault
        former = merged.get(key)
        if former is not None and is_shared:
            constants = (*_names(former.reason.args["constants"]), *_names(args["constants"]))
            reason = Reason.of("rules.constant_twice", constants=constants, tasks=args["tasks"], flow=args["flow"])
            merged[key] = replace(fault, reason=reason)
        else:
            merged[key] = fault
    return list(merged.values())


def _names(value: Argument) -> tuple[str, ...]:
    if isinstance(value, tuple):
        return tuple(map(str, value))
    return (str(value),)


def _special(reason: Reason) -> Reason | None:
    """The sentence of a reason that depends on its arguments."""
    args = reason.args
    match reason.key:
        case "rules.loop_tag_count" if args["count"] == 1:
            return Reason.of("run.loop_marked_once", tag=args["tag"])
        case "rules.condition_form" if "name" not in arguments(reason):
            return Reason.of("run.condition_at_branch", text=args["text"])
        case "runtime.port_unlike" if getattr(args["given"], "key", "") == "runtime.no_such_port":
            return _made("run.port_missing", args)
        case "rules.tags_as_often" | "rules.tags_as_often_always":
            return _in_vain(args["wait"])
        case "rules.tags_in_order" | "rules.tags_in_order_always":
            return _crossed(args["wait"])
    if reason.key in _WHY:
        why = args[_WHY[reason.key]]
        if isinstance(why, Reason):
            return simple(why)
        return Reason.plain(str(why))
    return None


def _in_vain(wait: Argument) -> Reason | None:
    if not isinstance(wait, Reason) or wait.key != "rules.flow_waits":
        return None
    args = arguments(wait)
    if "tag" in args:
        return _made("run.tag_in_vain", args)
    return None


def _crossed(wait: Argument) -> Reason | None:
    if not isinstance(wait, Reason) or wait.key != "rules.wait_which":
        return None
    first, further = wait.args["wait"], wait.args["further"]
    if not isinstance(first, Reason) or not isinstance(further, Reason):
        return None
    ours, theirs = arguments(first), arguments(further)
    is_pair = first.key == "rules.flow_waits" and "tag" in ours and "tag" in theirs and theirs["other"] == ours["flow"]
    if is_pair:
        return _made("run.tags_crossed", {**ours, "other_tag": theirs["tag"]})
    return None


def _made(key: str, args: Mapping[str, Argument]) -> Reason:
    return Reason.of(key, **{name: _argument(name, args[name]) for name in gaps(sentence("en", key))})


def _argument(name: str, value: Argument) -> Argument:
    if isinstance(value, tuple):
        return tuple(simple(item) if isinstance(item, Reason) else item for item in value)
    if isinstance(value, Reason):
        if value.key == "rules.tag_of":
            return value.args["tag"]
        return simple(value)
    if isinstance(value, str) and name in _KINDS:
        return kind_named(value)
    return value
