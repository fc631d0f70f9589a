"""The model with which an environment begins: libraries, preferences, buttons, syntax, and what could be opened."""

from collections.abc import Collection, Mapping
from pathlib import Path

from onika.desk.environment.file import file_index
from onika.desk.environment.icons.syntax import with_syntax
from onika.desk.environment.outcome.file_faults import told
from onika.desk.environment.state import settings
from onika.desk.environment.state.arrangements import with_arrangements
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.store.library import open_libraries
from onika.store.own_copy import own_copies
from onika.store.site import Site
from onika.wire import page


def opened(
    site: Site, state: Path | None, environment: Mapping[str, str], dictionaries: Collection[Path] = ()
) -> tuple[Model, tuple[page.Say, ...]]:
    """Everything of a site that an environment needs, and a line for each thing that is wrong with it.

    dictionaries   the base directories whose dictionaries are open at first; none named: all

    A directory of the search path that is none is told and passed over (requirement C20).
    """
    bases = [base for base in site.directories if base.path.is_dir()]
    libraries = open_libraries(bases)
    preferred, of_preferences = site.preferences()
    buttons, of_buttons = site.buttons()
    syntax, of_syntax = site.syntax()
    listed = file_index.listed(bases, syntax)
    ends, of_ends = site.flow_pictures()
    kept, of_settings = settings.read(state, environment)
    model = Model(
        libraries=OpenLibraries(libraries, preferences=preferred),
        preferences=preferred,
        settings=kept,
        buttons=buttons,
        search=tuple(base.path for base in site.directories),
        own_copies={str(copy.own): copy.laboratory for copy in own_copies(site)},
        flow_pictures=("".join(ends[0].rows), "".join(ends[1].rows)),
    )
    shown = [base for base in bases if not dictionaries or base.path in dictionaries]
    model = with_syntax(listed.beside(model), syntax, shown)
    model, of_arrangements = with_arrangements(model, site)
    faults = [*site.absent(), *of_preferences, *of_buttons, *of_syntax, *of_ends, *listed.faults, *of_arrangements]
    faults += [fault for dictionary in model.dictionaries for fault in dictionary.faults]
    faults += [fault for library in libraries for fault in library.faults]
    lines = [page.Say("warning", of_settings)] if of_settings else []
    return model, (*lines, *told(tuple(dict.fromkeys(faults))))
