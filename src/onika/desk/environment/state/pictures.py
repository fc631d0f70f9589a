"""The pictures that a page needs, each once, by a key that says what is in it."""

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from hashlib import blake2b
from itertools import chain

from onika.desk.environment.state.dictionary import Dictionary
from onika.desk.environment.state.open_application import OpenApplication
from onika.model.application import AppFlow, Icon, every_flow
from onika.model.picture import Picture

START, END = "start", "end"
_KEY_BYTES = 8
_MOST_SEEN = 1 << 13


_seen: dict[int, tuple[Picture, tuple[str, str]]] = {}
"""Pictures by their ids; each is kept, so that no other has its id."""


def drawn(picture: Picture) -> tuple[str, str]:
    """The key of a picture and its digits; asked for every icon with every change, so one is not read again."""
    picture_seen = _seen.get(id(picture))
    if picture_seen is None:
        if len(_seen) >= _MOST_SEEN:
            _seen.clear()
        picture_seen = _seen[id(picture)] = picture, _drawn(picture)
    return picture_seen[1]


@lru_cache(maxsize=1 << 16)  # a picture that is read again from its file is another object
def _drawn(picture: Picture) -> tuple[str, str]:
    digits = "".join(picture.rows)
    return blake2b(digits.encode(), digest_size=_KEY_BYTES).hexdigest(), digits


def key_of(picture: Picture) -> str:
    """The key of a picture in `view.Tree.pictures`."""
    return drawn(picture)[0]


class PictureSet:
    """The digits of every picture that is to be seen, by key; what was looked at once is not looked at again."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[object, Mapping[str, str]]] = {}
        """What a dictionary or a flow has, by its id; it is kept with it, so that nothing else has that id."""
        self._parts: list[Mapping[str, str]] = []
        self._shown: dict[str, str] = {}

    def shown(
        self, dictionaries: Iterable[Dictionary], applications: Mapping[str, OpenApplication], ends: tuple[str, str]
    ) -> dict[str, str]:
        """Every picture of these; `ends` are those of the start and end icons. The same dict where nothing is new."""
        former, self._known = self._known, {}
        every: list[Dictionary | AppFlow] = [*dictionaries, *_flows(applications)]
        for part in every:
            former_pictures = former.get(id(part))
            self._known[id(part)] = (
                former_pictures
                if former_pictures and former_pictures[0] is part
                else (part, dict(map(drawn, _pictures(part))))
            )
        parts = [{START: ends[0], END: ends[1]}, *(mapping for _, mapping in self._known.values())]
        if parts != self._parts:  # mostly a flow has what it had before: thousands need not be put together then
            self._parts = parts
            shown_pictures = dict(chain.from_iterable(part.items() for part in parts))
            self._shown = self._shown if shown_pictures == self._shown else shown_pictures
        return self._shown


def _flows(applications: Mapping[str, OpenApplication]) -> Iterator[AppFlow]:
    for application in applications.values():
        yield from (flow for _, flow in every_flow(application.application))


def _pictures(source: Dictionary | AppFlow) -> Iterator[Picture]:
    if isinstance(source, Dictionary):
        return (icon.value.picture for icon in source.onikons.values())
    return (step.onikon.picture for step in source.steps if isinstance(step, Icon))
