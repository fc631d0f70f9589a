"""Where a step stands in an open application: the path of its flow, and its position there.

A flow is named by its path: `1` is flow 1 of the application, `1/17/0` flow 0 of the branch numbered 17 in it.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple

from onika.model.application import AppFlow, Application, Branch, Step


class StepAddress(NamedTuple):
    """A step of an application."""

    path: str
    position: int
    step: Step


def flows_by_path(application: Application) -> Iterator[tuple[str, AppFlow]]:
    """All flows, those of branches behind the one they stand in, each with its path."""
    for number, flow in enumerate(application.flows):
        yield from _within(flow, str(number))


def spots(application: Application) -> dict[int, StepAddress]:
    """Every step by its number."""
    return {
        step.number: StepAddress(path, position, step)
        for path, flow in flows_by_path(application)
        for position, step in enumerate(flow.steps)
    }


def spot_of(application: Application, number: int) -> StepAddress | None:
    """Where the step of this number is; None: there is none. Cheaper than `spots`, whose one it is."""
    for path, flow in flows_by_path(application):
        for position, step in enumerate(flow.steps):
            if step.number == number:
                return StepAddress(path, position, step)
    return None


def with_flows(application: Application, changed: dict[str, AppFlow]) -> Application:
    """With other flows at these paths; inner ones first where one lies within another."""
    for path in sorted(changed, key=lambda path: -path.count("/")):
        first, *way = path.split("/")
        flow = _put(application.flows[int(first)], way, changed[path])
        application = replace(application, flows=_exchanged(application.flows, int(first), flow))
    return application


def with_step(application: Application, number: int, step: Step) -> Application:
    """With another step in place of the one of this number; raises KeyError where there is none."""
    path, position, _ = spots(application)[number]
    flow = dict(flows_by_path(application))[path]
    steps = (*flow.steps[:position], step, *flow.steps[position + 1 :])
    return with_flows(application, {path: AppFlow(steps)})


def numbered(application: Application, last: int) -> tuple[Application, int]:
    """Every step without a number gets the next one; and the last number that was given. The rest is as it was."""
    count = _Count(last)
    flows = tuple(count.flow(flow) for flow in application.flows)
    if all(map(_is, flows, application.flows)):
        return application, last
    return replace(application, flows=flows), count.last


def unnumbered(steps: Iterable[Step]) -> tuple[Step, ...]:
    """Steps as they are where they are not open, those of their branches too."""
    return tuple(_bare(step) for step in steps)


class _Count:
    """Gives numbers one after the other."""

    def __init__(self, last: int) -> None:
        self.last = last

    def flow(self, flow: AppFlow) -> AppFlow:
        steps = tuple(map(self._step, flow.steps))
        if all(map(_is, steps, flow.steps)):
            return flow
        return AppFlow(steps)

    def _step(self, step: Step) -> Step:
        if not step.number:
            self.last += 1
            step = replace(step, number=self.last)
        if isinstance(step, Branch):
            flows = tuple(map(self.flow, step.flows))
            step = step if all(map(_is, flows, step.flows)) else replace(step, flows=flows)
        return step


def _is(step: object, other: object) -> bool:
    return step is other


def _bare(step: Step) -> Step:
    if isinstance(step, Branch):
        return replace(step, flows=tuple(AppFlow(unnumbered(flow.steps)) for flow in step.flows), number=0, line=0)
    return replace(step, number=0, line=0)


def _within(flow: AppFlow, path: str) -> Iterator[tuple[str, AppFlow]]:
    yield path, flow
    for step in flow.steps:
        if isinstance(step, Branch):
            for number, inner in enumerate(step.flows):
                yield from _within(inner, f"{path}/{step.number}/{number}")


def _put(flow: AppFlow, way: list[str], new: AppFlow) -> AppFlow:
    if not way:
        return new
    number, inner, *rest = way
    at = next(at for at, step in enumerate(flow.steps) if step.number == int(number))
    branch = flow.steps[at]
    if not isinstance(branch, Branch):
        raise ValueError(f"expected the path of a flow, found the step {number}, which is no branch")
    flows = _exchanged(branch.flows, int(inner), _put(branch.flows[int(inner)], rest, new))
    return AppFlow((*flow.steps[:at], replace(branch, flows=flows), *flow.steps[at + 1 :]))


def _exchanged(flows: tuple[AppFlow, ...], at: int, flow: AppFlow) -> tuple[AppFlow, ...]:
    return (*flows[:at], flow, *flows[at + 1 :])
