"""Mutants of an application: each with one mistake that people make, to see whether a test catches it (R-X07).

for mutant in mutants(application, syntax, exchange={"jmoveC": right}):
    print(mutant.kind, mutant.text)
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from onika.model.application import Action, AppFlow, Application, Icon, Step, actions
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax


@dataclass(frozen=True, slots=True)
class Mutant:
    """An application with one mistake: what kind of, and in words where."""

    kind: str
    text: str
    application: Application


def mutants(application: Application, syntax: Syntax, exchange: Mapping[str, Onikon] | None = None) -> Iterator[Mutant]:
    """Every mutant of the first flow. `exchange`: jobs of another robot by the names of those they replace."""
    flow = application.flows[0]
    originals = actions(flow, syntax)
    blocks = [flow.steps[action.position : action.end] for action in originals]
    for at, action in enumerate(originals):
        name = f"action {at + 1} ({' '.join(icon.onikon.name for icon in _icons(blocks[at]))})"
        made = _made(at, action, blocks, exchange or {})
        for kind, steps in made:
            changed = replace(application, flows=(AppFlow(steps), *application.flows[1:]))
            yield Mutant(kind, f"{kind}: {name}", changed)
    if exchange and all(action.icon.onikon.name in exchange for action in originals):
        steps = tuple(_exchanged(step, exchange) for step in flow.steps)
        yield Mutant(
            "wrong robot",
            "wrong robot: every action",
            replace(application, flows=(AppFlow(steps), *application.flows[1:])),
        )


def _made(
    at: int, action: Action, blocks: list[tuple[Step, ...]], exchange: Mapping[str, Onikon]
) -> Iterator[tuple[str, tuple[Step, ...]]]:
    job = action.icon.onikon.name
    yield f"missing {job}", _flat([*blocks[:at], *blocks[at + 1 :]])
    yield "doubled action", _flat([*blocks[: at + 1], blocks[at], *blocks[at + 1 :]])
    if at + 1 < len(blocks) and _flat(blocks[at : at + 1]) != _flat(blocks[at + 1 : at + 2]):
        yield "swapped order", _flat([*blocks[:at], blocks[at + 1], blocks[at], *blocks[at + 2 :]])
    if job in exchange:
        other = _exchanged(action.icon, exchange)
        yield "wrong robot", _flat([*blocks[:at], (other, *blocks[at][1:]), *blocks[at + 1 :]])
    aims = _icons(blocks[at])[1:]
    if aims:
        for kind, aim in (("wrong target", _other(aims[0], blocks)), ("changed duration", _slower(aims[0]))):
            if aim is not None:
                yield kind, _flat([*blocks[:at], (action.icon, aim, *blocks[at][2:]), *blocks[at + 1 :]])


def _exchanged(step: Step, exchange: Mapping[str, Onikon]) -> Step:
    if isinstance(step, Icon) and step.onikon.name in exchange:
        return replace(step, onikon=exchange[step.onikon.name])
    return step


def _other(aim: Icon, blocks: list[tuple[Step, ...]]) -> Icon | None:
    """Another target of the same type from elsewhere in the flow, the next one round."""
    icons = {icon.onikon.name: icon for icon in _icons(_flat(blocks)) if icon.onikon.type == aim.onikon.type}
    names = list(icons)
    following = names[(names.index(aim.onikon.name) + 1) % len(names)]
    return icons[following] if following != aim.onikon.name else None


def _slower(aim: Icon) -> Icon:
    """The same target with half as much more time, which is its last value."""
    *values, (seconds,) = aim.onikon.values
    return replace(aim, onikon=replace(aim.onikon, values=(*values, (round(float(seconds) * 1.5, 3),))))


def _icons(steps: tuple[Step, ...]) -> list[Icon]:
    return [step for step in steps if isinstance(step, Icon)]


def _flat(blocks: list[tuple[Step, ...]]) -> tuple[Step, ...]:
    return tuple(step for block in blocks for step in block)
