"""What a page is shown, made of the model; parts that have not changed are the same objects again."""

from collections.abc import Mapping
from typing import Any

from onika.desk.environment.outcome.code_faults import code_problems
from onika.desk.environment.outcome.on_file import is_running
from onika.desk.environment.outcome.staleness import stale
from onika.desk.environment.outcome.supply import supply
from onika.desk.environment.outcome.trouble import problems
from onika.desk.environment.reconcile.watched_runs import is_on
from onika.desk.environment.show.application_view import ApplicationProjector
from onika.desk.environment.show.button_view import button_views
from onika.desk.environment.show.dictionary_view import dictionary_views, onikon_views
from onika.desk.environment.show.document_view import document_view, library_views, module_sentences, task_views
from onika.desk.environment.show.greying import GreyedTasks
from onika.desk.environment.show.load_preview import joined, shares, without_time
from onika.desk.environment.show.objections import objections
from onika.desk.environment.show.watched_document import in_run, stand_ins
from onika.desk.environment.show.wiring import MadeDocument
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.icon_types import type_views
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.state.pictures import PictureSet
from onika.desk.environment.state.preference_values import preference_values
from onika.desk.plan.icon_names import several
from onika.wire.view import ApplicationView, DocumentView, HoldView, Tree
from onika.words.reason import NOTHING


class Projector:
    """Makes the tree, and remembers what it made of which values."""

    def __init__(self) -> None:
        self._made: dict[str, tuple[tuple[Any, ...], Any]] = {}
        self._seen: dict[str, MadeDocument] = {}
        self._greying: dict[str, GreyedTasks] = {}
        self._sights: dict[str, ApplicationProjector] = {}
        self._album = PictureSet()

    def project(self, model: Model) -> Tree:
        """The tree of a model."""
        documents = {
            document.id: self._document(document, order, model)
            for order, document in enumerate(model.documents.values())
        }
        for closed in self._seen.keys() - documents.keys():
            self._forget(closed)
        return Tree(
            libraries=self._once(
                "libraries",
                (model.libraries.libraries, model.arrangements),
                lambda: library_views(model.libraries, model.arrangements),
            ),
            tasks=self._once("tasks", (model.libraries,), lambda: self._tasks(model.libraries)),
            module_sentences=self._once(
                "sentences", (model.libraries.libraries,), lambda: module_sentences(model.libraries)
            ),
            documents=documents,
            loads=self._loads(model),
            files=dict(model.files),
            own_copies=dict(model.own_copies),
            touched=dict(model.touched),
            application_files=dict(model.application_files),
            clipboard=" ".join(placed.task for placed in model.clipboard.placed),
            runtime=model.runtime,
            stations={name: runtime for name, runtime in model.every_station.items() if name},
            preferences=self._once(
                "preferences", (model.preferences, model.settings), lambda: preference_values(model)
            ),
            buttons=self._once("buttons", (model.buttons, model.runs), lambda: button_views(model)),
            job_types=model.job_types,
            edges=dict(model.edges),
            applications=self._applications(model),
            icon_clipboard=several(model.icon_clipboard) if model.icon_clipboard else NOTHING,
            **self._dictionaries(model),
            own_undo=model.own.last.label if model.own.last else NOTHING,
            own_redo=model.own.next.label if model.own.next else NOTHING,
            run=model.run.view if model.run is not None else None,
            beside={str(number): run.view for number, run in model.beside.items()},
            replay=model.replay,
            review=model.review_session.view(model.applications) if model.review_session is not None else None,
            keeping=model.keeping,
            people=model.people,
            class_seat=model.class_seat,
        )

    def _loads(self, model: Model) -> dict[str, float]:
        """What tasks would take of a unit; the same object where no share has changed to be seen."""
        libraries = model.libraries
        former: dict[str, float] = self._made.get("loads", ((), {}))[1]
        now: dict[str, float] = self._once(
            "loads",
            (libraries.tasks, libraries.rates, libraries.digests, model.cycles_us),
            lambda: shares(libraries, model.cycles_us),
        )
        if now == former:
            self._made["loads"] = (self._made["loads"][0], former)
            return former
        return now

    def _applications(self, model: Model) -> dict[str, ApplicationView]:
        """What is shown of open applications, by their ids."""
        for closed in self._sights.keys() - model.applications.keys():
            del self._sights[closed], self._made[f"application {closed}"]
        return {
            opened.id: self._application(opened, order, model)
            for order, opened in enumerate(model.applications.values())
        }

    def _application(self, opened: OpenApplication, order: int, model: Model) -> ApplicationView:
        sight = self._sights.setdefault(opened.id, ApplicationProjector())
        runs = is_running(model, opened.id)
        of = (opened, order, runs, model.syntax, model.dictionaries, model.own)
        view: ApplicationView = self._once(
            f"application {opened.id}", of, lambda: sight.view(opened, order, model, is_running=runs)
        )
        return view

    def _dictionaries(self, model: Model) -> dict[str, Any]:
        """What is shown of dictionaries, their icons and the types of these."""
        opened, libraries, syntax = model.dictionaries, model.libraries, model.syntax
        files = (model.files, model.application_files, model.sources)
        former = self._made.get("onikons", ((), {}))[1]
        tasks = (libraries.libraries, libraries.edits, libraries.sheets, model.limits)
        drawn = (opened, model.applications, model.flow_pictures)
        return {
            "dictionaries": self._once("dictionaries", (opened, model.arrangements), lambda: dictionary_views(model)),
            "onikons": self._once(
                "onikons", (opened, syntax, libraries.libraries, *files), lambda: onikon_views(model, former)
            ),
            "types": self._once("types", (syntax, *tasks), lambda: type_views(model)),
            "pictures": self._once("pictures", drawn, lambda: self._album.shown(*drawn)),
        }

    def _document(self, document: Document, order: int, model: Model) -> DocumentView:
        document = self._in_run(document, model)
        libraries, key = model.libraries_of(document), f"document {document.id}"
        seen = self._seen.get(document.id)
        names = document.content.names
        greyed = self._greying.setdefault(document.id, GreyedTasks(document.id)).greyed(names, libraries)
        objected = self._once(
            f"objections {document.id}",
            (names, libraries.tasks, libraries.sheets, libraries.unread),
            lambda: objections(document, libraries),
        )
        warned = model.settings.shows_warnings
        troubles = self._once(
            f"problems {document.id}",
            (names, (document.name,), libraries.tasks, warned),
            lambda: problems(document, libraries, with_warnings=warned, greyed=greyed),
        )
        living = document.live.tasks if document.live else None
        pending = document.live.pending if document.live else None
        runtime = model.runtime_at(document.station)
        behind = self._once(
            f"stale {document.id}",
            (document.content.configuration, living, pending, libraries, runtime.outdated, runtime.address),
            lambda: stale(document, libraries, runtime),
        )
        lacking = self._once(
            f"supply {document.id}",
            (document.content.configuration, living, pending, libraries.tasks),
            lambda: supply(document, libraries),
        )
        wrong_code = self._once(
            f"code {document.id}",
            (names, libraries.tasks, libraries.unread, model.code_faults),
            lambda: code_problems(document, libraries, model.code_faults),
        )
        parts = (wrong_code, troubles, lacking, behind)
        troubles = self._once(f"troubles {document.id}", parts, lambda: parts[0] | parts[1] | parts[2] | parts[3])
        late = self._once(
            f"load {document.id}",
            (document, libraries.tasks, self._loads(model), runtime.units),
            lambda: without_time(document, libraries, self._loads(model), runtime.units),
        )
        greyed = self._once(f"greyed {document.id}", (greyed, late), lambda: joined(greyed, late))
        view: DocumentView = self._once(
            key,
            (document, order, libraries, greyed, objected, troubles, model.own),
            lambda: document_view(document, order, model, greyed, objected, troubles, seen),
        )
        self._seen[document.id] = MadeDocument(document, libraries, view)
        return view

    def _in_run(self, document: Document, model: Model) -> Document:
        """As it is shown where it looks into a running application."""
        watched = document.watched
        if watched is None or not is_on(model, watched):
            return document
        runtime = model.runtime_at(watched.station)
        subsystem, substitutes = runtime.inside[watched.subsystem], stand_ins(model, watched.subsystem)
        holder = runtime.holds.get(watched.subsystem, HoldView()).holder
        me = next((name for name, session in runtime.sessions.items() if session.is_you), "")
        seen: Document = self._once(
            f"run {document.id}",
            (document, subsystem, (holder, me), substitutes),
            lambda: in_run(document, subsystem, holder, me, substitutes),
        )
        return seen

    def _forget(self, doc: str) -> None:
        """A document is closed, and its id is never used again."""
        del self._seen[doc], self._greying[doc]
        for key in [key for key in self._made if key.endswith(f" {doc}")]:
            del self._made[key]

    def _tasks(self, libraries: OpenLibraries) -> Mapping[str, Any]:
        of, former = self._made.get("tasks", ((None,), {}))
        return task_views(libraries, former, of[0])

    def _once(self, key: str, of: tuple[Any, ...], make: Any) -> Any:
        """What `make` gives, made anew only where one of `of` is another object."""
        made_before = self._made.get(key)
        if made_before is not None and all(_is_same(old, new) for old, new in zip(made_before[0], of, strict=True)):
            return made_before[1]
        made = make()
        self._made[key] = (of, made)
        return made


def _is_same(old: Any, new: Any) -> bool:
    return old is new or (isinstance(old, tuple) and old == new)
