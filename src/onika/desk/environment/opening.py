"""The model with which an environment begins: libraries, preferences, buttons, syntax, and what could be opened."""

from collections.abc import Mapping
from pathlib import Path

from onika.desk.environment import habits, listing
from onika.desk.environment.libraries import told
from onika.desk.environment.model import Model
from onika.desk.environment.remedy import plain
from onika.desk.environment.shelf import Shelf
from onika.model.syntax import Edge, Syntax
from onika.store.library import open_libraries
from onika.store.site import Site
from onika.wire import page


def opened(site: Site, state: Path | None, environment: Mapping[str, str]) -> tuple[Model, tuple[page.Say, ...]]:
    """Everything of a site that an environment needs, and a line for each thing that is wrong with it.

    A directory of the search path that is none is told and passed over (requirement C20).
    """
    bases = [base for base in site.directories if base.path.is_dir()]
    libraries = open_libraries(bases)
    files, of_files = listing.listed(bases)
    preferred, of_preferences = site.preferences()
    buttons, of_buttons = site.buttons()
    syntax, of_syntax = site.syntax()
    kept, of_habits = habits.read(state, environment)
    model = Model(
        shelf=Shelf(libraries, preferences=preferred),
        preferences=preferred,
        habits=kept,
        buttons=buttons,
        files=files,
        job_types=_job_types(syntax),
        edges=_edges(syntax),
    )
    faults = [*site.absent(), *of_preferences, *of_buttons, *of_syntax, *of_files]
    faults += [fault for library in libraries for fault in library.faults]
    lines = [page.Say("warning", plain(of_habits))] if of_habits else []
    return model, (*lines, *told(tuple(dict.fromkeys(faults))))


def _job_types(syntax: Syntax | None) -> tuple[str, ...]:
    return tuple(kind.name for kind in syntax.types if kind.is_job) if syntax else ()


def _edges(syntax: Syntax | None) -> dict[str, tuple[str, tuple[tuple[int, int], ...]]]:
    """Colour and vertices of every edge, by its number."""
    return {str(edge.number): (_colour(edge), edge.vertices) for edge in syntax.edges} if syntax else {}


def _colour(edge: Edge) -> str:
    return "#" + "".join(f"{part:02x}" for part in edge.rgb)
