"""Check the configuration, on demand: all rules and all warnings, also where these are switched off (C26)."""

from onika.desk.environment.outcome.on_application import is_application, on_application
from onika.desk.environment.outcome.on_document import on_document
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.outcome.trouble import problems
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.wire import act

_ORDER = ("fault", "warning", "note")


def check(model: Model, asked: act.Check, outside: Surroundings) -> Done | No:
    """The value is the sentences, what is wrong first; none where all is well."""
    return (_application if is_application(asked.doc) else _configuration)(model, asked, outside)


@on_application
def _application(model: Model, opened: OpenApplication, _asked: act.Check, _outside: Surroundings) -> Done | No:
    faults = (*opened.file_faults, *(opened.judgement.faults if opened.judgement else ()))
    return Done(model, value=tuple(one.text for one in sorted(faults, key=lambda one: _ORDER.index(one.level))))


@on_document
def _configuration(model: Model, document: Document, asked: act.Check, _outside: Surroundings) -> Done | No:
    found = sorted(problems(document, model.shelf).values(), key=lambda one: _ORDER.index(one.level))
    return Done(model, value=tuple(one.text for one in found))
