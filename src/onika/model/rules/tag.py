"""Whether the synchronisation tags of an application have a meaning (requirement E04, readings 26 and 27)."""

from collections.abc import Iterator

from onika.model.rules.outline import Outline, Passage
from onika.words.fault import Fault
from onika.words.reason import Reason

_Marks = dict[str, dict[int, tuple[Passage, int]]]
"""For every tag, the flows it stands in, each with its first place there."""


def faults(outline: Outline) -> Iterator[Fault]:
    """A tag in one flow of a parallel application only; where nothing is parallel, a note that it is ignored.

    A tag in a branch stands in the flow of that branch.
    """
    marks: _Marks = {}
    for passage, action in outline.actions():
        if action.icon.synch_tag is not None:
            flows = marks.setdefault(action.icon.synch_tag, {})
            flows.setdefault(passage.number, (passage, action.position))
    for tag, flows in marks.items():
        passage, position = next(iter(flows.values()))
        icon, at = passage.flow.steps[position], outline.at(passage, position)
        if not outline.application.is_parallel:
            idle = Reason.of("rules.tag_not_parallel", tag=tag, at=at)
            yield outline.note(icon, idle, Reason.of("rules.ignored"))
        elif len(flows) == 1:
            yield outline.fault(
                icon, Reason.of("rules.tag_alone", tag=tag, application=outline.application.name, at=at)
            )
