"""The pictures that a page needs, each once, by a key that says what is in it."""

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from hashlib import blake2b

from onika.desk.upper.dictionary.dictionary import Dictionary
from onika.desk.upper.flow.open_application import OpenApplication
from onika.model.application import AppFlow, Icon, every_flow
from onika.model.picture import Picture

START, END = "start", "end"
_KEY_BYTES = 8


@lru_cache(maxsize=1 << 16)  # asked for every icon with every change, and hashing is most of the time
def drawn(picture: Picture) -> tuple[str, str]:
    """The key of a picture and its 1024 digits."""
    digits = "".join(picture.rows)
    return blake2b(digits.encode(), digest_size=_KEY_BYTES).hexdigest(), digits


def key_of(picture: Picture) -> str:
    """The key of a picture in `view.Tree.pictures`."""
    return drawn(picture)[0]


class Album:
    """The digits of every picture that is to be seen, by key; what was looked at once is not looked at again."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[object, Mapping[str, str]]] = {}
        """What a dictionary or a flow has, by its id; it is kept with it, so that nothing else has that id."""
        self._shown: dict[str, str] = {}

    def shown(
        self, dictionaries: Iterable[Dictionary], applications: Mapping[str, OpenApplication], ends: tuple[str, str]
    ) -> dict[str, str]:
        """Every picture of these; `ends` are those of the start and end icons. The same dict where nothing is new."""
        former, self._known = self._known, {}
        found = {START: ends[0], END: ends[1]}
        every: list[Dictionary | AppFlow] = [*dictionaries, *_flows(applications)]
        for one in every:
            known = former.get(id(one))
            self._known[id(one)] = known if known and known[0] is one else (one, dict(map(drawn, _pictures(one))))
            found |= self._known[id(one)][1]
        if found != self._shown:
            self._shown = found
        return self._shown


def _flows(applications: Mapping[str, OpenApplication]) -> Iterator[AppFlow]:
    for one in applications.values():
        yield from (flow for _, flow in every_flow(one.application))


def _pictures(one: Dictionary | AppFlow) -> Iterator[Picture]:
    if isinstance(one, Dictionary):
        return (icon.value.picture for icon in one.onikons.values())
    return (step.onikon.picture for step in one.steps if isinstance(step, Icon))
