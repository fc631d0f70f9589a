"""Why a model cannot be used, with its file and line (requirement X19).

MuJoCo names the line of what it cannot read or compile in most cases, else the element; our own checks name that.
"""

import re
from collections.abc import Iterator, Sequence

from onika.wire.world_source import WorldFile
from onika.words.fault import Place
from onika.words.reason import Reason

_LINE = re.compile(r"\bline (?:number=)?([1-9]\d*)", re.IGNORECASE)
_ELEMENT = "Element name '"
_NAMING = ("joint", "name")
"""What names the element in a reason of ours."""
OF_MODELS = ("workcell.model_unsound", "workcell.place_no_number", "workcell.limit_reversed")
"""Reasons that speak of an element of a model, which stands in a line of that."""


class ModelFault(ValueError):
    """A model that cannot be used: raised with the reason, and where it stands in the model's file."""

    def __init__(self, reason: Reason, place: Place) -> None:
        super().__init__(reason)
        self.place = place


def model_fault(reason: Reason, files: Sequence[WorldFile], prefix: str = "") -> ModelFault:
    """The reason at its line: in the first of the files, the model, or in one that it includes.

    prefix   what stands before the names of the model's elements in the document that could not be compiled
    """
    model, *included = files
    said = _LINE.search(reason.text)
    if said is not None:
        return ModelFault(reason, Place(model.path, int(said[1])))
    names = [name.removeprefix(prefix) for name in element_names(reason)]
    for file in files:
        for name in names:
            if line := line_of(file, name):
                return ModelFault(reason, Place(file.path, line))
    return ModelFault(reason, Place(model.path, _line(model, rb"<\s*include\b") if included else 0))


def element_names(reason: Reason) -> Iterator[str]:
    """The element of which a reason speaks."""
    name = reason.text.partition(_ELEMENT)[2].partition("'")[0]
    yield from [name] if name else ()
    yield from (str(reason.args[key]) for key in _NAMING if key in reason.args)


def line_of(file: WorldFile, name: str, attribute: str = "name") -> int:
    """The line where an element of a model has its name; 0: none has it."""
    return _line(file, rf"""\b{attribute}\s*=\s*["']{re.escape(name)}["']""".encode())


def _line(file: WorldFile, pattern: bytes) -> int:
    found = re.search(pattern, file.content)
    return file.content.count(b"\n", 0, found.start()) + 1 if found is not None else 0
