"""Check the configuration, on demand: all rules and all warnings, also where these are switched off (C26)."""

from onika.desk.environment.document import Document
from onika.desk.environment.model import Model
from onika.desk.environment.on_document import on_document
from onika.desk.environment.outcome import Done, No
from onika.desk.environment.surroundings import Surroundings
from onika.desk.environment.trouble import problems
from onika.wire import act

_ORDER = ("fault", "warning", "note")


@on_document
def check(model: Model, document: Document, asked: act.Check, _outside: Surroundings) -> Done | No:
    """The value is the sentences, what is wrong first; none where all is well."""
    found = sorted(problems(document, model.shelf).values(), key=lambda one: _ORDER.index(one.level))
    return Done(model, value=tuple(one.text for one in found))
