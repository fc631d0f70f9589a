"""Check the configuration, on demand: all rules and all warnings, also where these are switched off (C26)."""

from typing import Protocol

from onika.desk.environment.file.elsewhere import differences
from onika.desk.environment.outcome.code_faults import code_problems
from onika.desk.environment.outcome.on_file import AnyFile, on_file
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.trouble import problems
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.wire import act

_ORDER = ("fault", "warning", "note")


@on_file
def check(model: Model, file: AnyFile, _command: act.Check, outside: Services) -> Done | No:
    """The value is the sentences, what is wrong first; none where all is well."""
    if isinstance(file, OpenApplication):
        faults = (*file.file_faults, *(file.judgement.faults if file.judgement else ()))
        return Done(model, value=tuple(fault.text for fault in sorted(faults, key=_order)))
    libraries = model.libraries_of(file)
    wrong_code = code_problems(file, libraries, model.code_faults)
    troubles = sorted((problems(file, libraries) | wrong_code).values(), key=_order)
    others = differences(model, file.content.configuration, file.base, outside.site)
    return Done(model, value=(*(trouble.text for trouble in troubles), *others.values()))


class _Levelled(Protocol):
    @property
    def level(self) -> str: ...


def _order(fault: _Levelled) -> int:
    return _ORDER.index(fault.level)
