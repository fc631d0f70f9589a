"""What a runtime tells of a run, as a page shows it: questions, standstills, the last seconds (requirement X06)."""

from msgspec import structs

from onika.desk.environment.run_state.run import Run
from onika.wire import act, event
from onika.wire.view import ChoiceView, CourseView, Remedy, StopView
from onika.words.reason import NOTHING, Argument, Reason

_ANY_ACTION = "N"
"""Stands in a line of steering for the number of an action that is not chosen yet."""
_DESERTED = "deserted"
_OWN = ("ModuleError", "LawBroken")
"""The errors that a module raises for people to read."""
_MOST_SAMPLES = 120
"""Of a variable's last seconds: more than that are not told apart on a screen."""


def stop_view(run: Run, explained: event.Explained) -> StopView:
    """Why a flow stands still, or the run ends."""
    failed = run.failures.get(f"{explained.subsystem}/{explained.task}")
    text = run.wording.with_icons(explained.text)
    return StopView(
        text=text,
        short=in_short(text),
        kind=explained.kind,
        at_s=explained.at_s,
        subsystem=explained.subsystem,
        task=explained.task,
        step=run.step_at(explained.subsystem, explained.index),
        action=run.called(explained.subsystem, explained.index) or explained.action,
        index=explained.index,
        suspect=explained.suspect,
        path=explained.path,
        line=explained.line,
        traceback=failed.traceback if failed else "",
        waiting=explained.waiting,
        courses=tuple(map(_course, explained.courses)),
        choices=tuple(
            _choice(command, run.wording.with_icons(meaning), run, explained) for command, meaning in explained.choices
        ),
    )


def with_black_box(stop: StopView, kept: event.LastSecondsKept) -> StopView:
    """A standstill, with the file of the last seconds before it where that is the one that is told of."""
    is_meant = (stop.subsystem, stop.at_s) == (kept.subsystem, kept.at_s)
    return structs.replace(stop, black_box=kept.path) if is_meant else stop


def left_for(run: Run, subsystem: str) -> set[str]:
    """The flows that are told to wait for ever for this one, straight or through others."""
    flows, waiting = run.view.flows, {subsystem}
    while True:
        more = {name for name, flow in flows.items() if name not in waiting and waiting & set(flow.waits_for)}
        if not more:
            return {
                subsystem
                for subsystem in waiting
                if subsystem in run.view.stops and run.view.stops[subsystem].kind == _DESERTED
            }
        waiting |= more


def standing(run: Run, whom: str) -> list[tuple[Reason, Remedy]]:
    """The flows that stand and do not pause, or the one of a subsystem: why, and what lets each go on."""
    flows = {name: flow for name, flow in run.view.flows.items() if whom in ("", name)}
    ways = []
    for name, flow in flows.items():
        if flow.state == "stopped":
            clear = Remedy(Reason.of("run.clear_flow", flow=name), act.Steer(f"clear {name}", run.doc))
            ways.append((Reason.of("run.flow_at_error", flow=name), clear))
        elif flow.state == "waiting":
            let_pass = Remedy(Reason.of("run.let_pass", flow=name), act.Steer(f"pass {name}", run.doc))
            if flow.waits_for:
                why = Reason.of("run.flow_waits_for", flow=name, tag=flow.tag, others=flow.waits_for)
            else:
                why = Reason.of("run.flow_waits", flow=name, tag=flow.tag)
            ways.append((why, let_pass))
    return ways


def is_question(text: Reason) -> bool:
    """Whether it says only that a task asks, which is shown as a question anyway."""
    return text.key in ("engine.asks", "engine.asks_again")


def in_short(text: Reason) -> Reason:
    """What was said, without where in a module: a module's own error is a sentence for people."""
    match text.key:
        case "host.cause_suspected":
            cause = text.args["cause"]
            shown = in_short(cause) if isinstance(cause, Reason) else cause
            return Reason.of("host.cause_suspected", cause=shown, suspicion=text.args["suspicion"])
        case "host.entry_failed":
            return _own_words(text.args["why"]) or text
    return text


def _own_words(why: Argument) -> Reason:
    """What a module has raised for people to read; nothing where it is an error of another kind."""
    if not isinstance(why, Reason):
        return NOTHING
    match why.key:
        case "runtime.raised" if why.args["kind"] in _OWN:
            inner = why.args["why"]
            return inner if isinstance(inner, Reason) else Reason.plain(str(inner))
        case "runtime.first_written":
            reason = _own_words(why.args["reason"])
            if reason:
                return Reason.of("runtime.first_written", **{**why.args, "reason": reason})
    return NOTHING


def loops(names: tuple[str, ...]) -> tuple[str, ...]:
    """Loops by the words of their tags, outermost first."""
    return tuple(name.rpartition("/")[2].partition("#")[0] for name in names)


def tag(text: str) -> str:
    """A synchronisation tag by the word that stands in the file."""
    return text.rpartition(" ")[2]


def _choice(command: str, meaning: Reason, run: Run, explained: event.Explained) -> ChoiceView:
    """What a line of steering does; one that leaves open which action is not done at once, if there are several."""
    verb, *operands = command.split()
    if operands[-1:] != [_ANY_ACTION]:
        return ChoiceView(verb, meaning, " ".join(operands), act.Steer(command, run.doc))
    subsystem = " ".join(operands[:-1]) or explained.subsystem
    others = set(range(run.flow_index.count(subsystem))) - {explained.index if subsystem == explained.subsystem else -1}
    only = act.Steer(f"{verb} {subsystem} {others.pop() + 1}", run.doc) if len(others) == 1 else None
    return ChoiceView(verb, meaning, " ".join(operands[:-1]), only)


def _course(course: event.Course) -> CourseView:
    every = max(1, -(-len(course.at_s) // _MOST_SAMPLES))
    newest = slice((len(course.at_s) - 1) % every, None, every)
    return CourseView(course.variable, course.unit, course.at_s[newest], course.values[newest])
