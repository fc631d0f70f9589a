"""How dictionaries and their icons look to a page."""

from collections.abc import Mapping

from onika.desk.environment.outcome.icon_source import Sources
from onika.desk.environment.state import target_values
from onika.desk.environment.state.dictionary import Dictionary
from onika.desk.environment.state.icon_types import edges_of, role_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.pictures import key_of
from onika.model.application import wanted_targets
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.store.opened_text import OpenedText
from onika.store.shipped import is_shipped
from onika.wire.view import DictionaryView, OnikonView


def dictionary_views(model: Model) -> dict[str, DictionaryView]:
    """The open dictionaries, by the paths of their base directories."""
    return {
        str(dictionary.base.path): DictionaryView(
            name=dictionary.base.path.name,
            path=str(dictionary.base.path),
            order=order,
            onikons=len(dictionary.onikons),
            faults=tuple(fault.sentence for fault in dictionary.faults),
            arranged=model.arrangements.get(str(dictionary.base.path / "dict"), ()),
            is_shipped=is_shipped(dictionary.base.path),
        )
        for order, dictionary in enumerate(model.dictionaries)
    }


def onikon_views(model: Model, former: Mapping[str, OnikonView]) -> dict[str, OnikonView]:
    """Every icon of the open dictionaries, by name; what looks as it did in `former` is the same object."""
    syntax = model.syntax
    if syntax is None:
        return {}
    sources = Sources(model, syntax)
    views = {}
    for dictionary in model.dictionaries:
        for order, (name, opened) in enumerate(dictionary.onikons.items()):
            view = _view(opened, order, dictionary, sources, syntax)
            former_view = former.get(name)
            views[name] = former_view if former_view is not None and former_view == view else view
    return views


def _view(
    opened: OpenedText[Onikon], order: int, dictionary: Dictionary, sources: Sources, syntax: Syntax
) -> OnikonView:
    onikon = opened.value
    kind = syntax.acting(onikon.type)
    left, right = edges_of(kind)
    source = sources.path_of(onikon, dictionary)
    return OnikonView(
        type=onikon.type,
        role=role_of(kind),
        order=order,
        dictionary=str(dictionary.base.path),
        left=left,
        right=right,
        picture=key_of(onikon.picture),
        description=onikon.description,
        words=dict(onikon.words),
        values=target_values.shown(onikon, syntax),
        takes=wanted_targets(onikon, syntax),
        path=str(opened.path),
        source=source,
        trouble=sources.trouble(onikon, source),
        hardware=sources.hardware(source),
        arm=onikon.arm,
    )
