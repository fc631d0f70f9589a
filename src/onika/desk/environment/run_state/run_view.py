"""What a runtime tells of a run, as a page shows it: questions, standstills, the last seconds (requirement X06)."""

import re

from onika.desk.environment.run_state.run import Run
from onika.desk.plan.icon_names import listed
from onika.wire import act, event
from onika.wire.view import CourseView, Remedy, StopView

_DESERTED = "deserted"
_ASKS = re.compile(r": \S+ asks(: .*)?$")
_MOST_SAMPLES = 120
"""Of a variable's last seconds: more than that are not told apart on a screen."""


def stop_view(run: Run, told: event.Explained) -> StopView:
    """Why a flow stands still, or the run ends."""
    failed = run.failures.get(f"{told.subsystem}/{told.task}")
    return StopView(
        text=run.speech.said(told.text),
        kind=told.kind,
        at_s=told.at_s,
        subsystem=told.subsystem,
        task=told.task,
        step=run.step_at(told.subsystem, told.index),
        action=run.called(told.subsystem, told.index) or told.action,
        index=told.index,
        suspect=told.suspect,
        path=told.path,
        line=told.line,
        traceback=failed.traceback if failed else "",
        waiting=told.waiting,
        courses=tuple(map(_course, told.courses)),
        choices=tuple(_choice(words, run, told) for words, _ in told.choices),
        meanings=tuple(run.speech.meaning(meaning) for _, meaning in told.choices),
    )


def left_for(run: Run, subsystem: str) -> set[str]:
    """The flows that are told to wait for ever for this one, straight or through others."""
    flows, found = run.view.flows, {subsystem}
    while True:
        more = {name for name, one in flows.items() if name not in found and found & set(one.waits_for)}
        if not more:
            return {one for one in found if one in run.view.stops and run.view.stops[one].kind == _DESERTED}
        found |= more


def standing(run: Run, whom: str) -> list[tuple[str, Remedy]]:
    """The flows that stand and do not pause, or the one of a subsystem: why, and what lets each go on."""
    flows = {name: one for name, one in run.view.flows.items() if whom in ("", name)}
    found = []
    for name, one in flows.items():
        if one.state == "stopped":
            found.append((f"{name} stands at an error", Remedy(f"Clear {name}", act.Steer(f"clear {name}"))))
        elif one.state == "waiting":
            others = f" for {listed(one.waits_for)}" if one.waits_for else ""
            text = f"{name} waits at {one.tag}{others}"
            found.append((text, Remedy(f"Let {name} pass", act.Steer(f"pass {name}"))))
    return found


def is_question(text: str) -> bool:
    """Whether it says only that a task asks, which is shown as a question anyway."""
    return _ASKS.search(text) is not None


def loops(names: tuple[str, ...]) -> tuple[str, ...]:
    """Loops by the words of their tags, outermost first."""
    return tuple(one.rpartition("/")[2].partition("#")[0] for one in names)


def tag(told: str) -> str:
    """A synchronisation tag by the word that stands in the file."""
    return told.rpartition(" ")[2]


def _choice(words: str, run: Run, told: event.Explained) -> Remedy:
    """A word of steering; one that leaves open which action is shown and not done at once, if there are several."""
    if not words.endswith(" N"):
        return Remedy(words, act.Steer(words))
    verb, *whom = words.split()[:-1]
    subsystem = whom[0] if whom else told.subsystem
    others = set(range(run.cast.count(subsystem))) - {told.index if subsystem == told.subsystem else -1}
    return Remedy(words, act.Steer(f"{verb} {subsystem} {others.pop() + 1}") if len(others) == 1 else None)


def _course(one: event.Course) -> CourseView:
    every = max(1, -(-len(one.at_s) // _MOST_SAMPLES))
    newest = slice((len(one.at_s) - 1) % every, None, every)
    return CourseView(one.variable, one.unit, one.at_s[newest], one.values[newest])
