"""The syntax definition comes, or comes anew: types, edges and dictionaries follow, without code (D02, D16)."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.file import file_index
from onika.desk.environment.outcome.file_faults import told
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.dictionary import has_dictionary, open_dictionaries
from onika.desk.environment.state.model import Model
from onika.desk.plan.icon_names import kind_named
from onika.model.syntax import Edge, Syntax
from onika.store.base_directory import BaseDirectory
from onika.store.site import Site
from onika.wire import page
from onika.words.reason import Reason


def with_syntax(model: Model, syntax: Syntax | None, bases: Iterable[BaseDirectory]) -> Model:
    """With this syntax, and the dictionaries of these base directories read by it."""
    if syntax is None:
        return model
    return replace(
        model,
        syntax=syntax,
        job_types=tuple(kind.name for kind in syntax.types if kind.is_job),
        edges={str(edge.number): (_colour(edge), edge.vertices) for edge in syntax.edges},
        dictionaries=open_dictionaries((base for base in bases if has_dictionary(base)), syntax),
    )


def redefined(model: Model, site: Site) -> Done:
    """With the syntax as its files say now; icons and applications are read by it again, what is placed stays."""
    syntax, faults = site.syntax()
    says = told(faults)
    if syntax is None or syntax == model.syntax:
        return Done(model, says=says)
    defined = with_syntax(model, syntax, (dictionary.base for dictionary in model.dictionaries))
    for path in model.application_files:
        reread = file_index.again(Path(path), syntax)
        defined = reread.beside(defined) if reread else defined
    names = {kind.name for kind in model.syntax.types} if model.syntax else set()
    new = [kind.name for kind in syntax.types if kind.name not in names]
    kinds = tuple(map(kind_named, new))
    plain = Reason.of("desk.syntax_defined_anew")
    text = Reason.of("desk.syntax_defined_with", kinds=kinds) if kinds else plain
    old = {fault for dictionary in model.dictionaries for fault in dictionary.faults}
    faults = tuple(fault for dictionary in defined.dictionaries for fault in dictionary.faults if fault not in old)
    return Done(defined, says=(*says, page.Say("info", text), *told(faults)))


def _colour(edge: Edge) -> str:
    return "#" + "".join(f"{part:02x}" for part in edge.rgb)
