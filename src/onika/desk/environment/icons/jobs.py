"""A configuration or an application becomes an icon: type, warnings, picture, file (C16, D09, §5.6.2, §5.6.4)."""

from dataclasses import replace

import msgspec

from onika.desk.environment.canvas.draft import Draft, drafted
from onika.desk.environment.file import file_index
from onika.desk.environment.file.elsewhere import differences
from onika.desk.environment.icons import application_icon
from onika.desk.environment.icons.dictionaries import shown_at_once
from onika.desk.environment.outcome.on_file import closed
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.icon_words import forgotten, told_again
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.desk.environment.state.picture_digits import painted
from onika.desk.plan.icon_names import kind_named
from onika.model.onikon import Onikon
from onika.model.picture import Picture
from onika.store.own_copy import saving_place
from onika.wire import act, page
from onika.wire.view import DraftView, Remedy, ShowSaveAs
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason


def draft(model: Model, command: act.Draft, outside: Services) -> Done | No:
    """What icon a configuration or an application would make; the value is a `view.DraftView`."""
    job = _drafted(model, command.doc, outside)
    if isinstance(job, No):
        return job
    return Done(model, value=_view(job))


def make_job(model: Model, command: act.MakeJob, outside: Services) -> Done | No:
    """Save the onikon of a configuration or application beside it; the value is the path of its file."""
    job = _drafted(model, command.doc, outside)
    if isinstance(job, No):
        return job
    picture = painted(command.picture)
    if not isinstance(picture, Picture):
        return No(Reason.of("desk.picture_unkept", why=picture), fields={"picture": picture})
    name, home = job.name, saving_place(job.home.path, outside.site)
    if isinstance(home, Refusal):
        return No(home.reason)
    path = home.onikon_file(name)
    meant = Remedy(Reason.of("desk.replace_it"), msgspec.structs.replace(command, overwrites=True))
    if path.exists() and not command.overwrites:
        return No(job.taken or Reason.of("desk.there_already", path=str(path)), (meant,))
    description = " ".join(command.description.split())
    words = told_again(job.former.value, description) if job.former else ()
    made = Onikon(name, job.kind.type, description, (), picture, job.kind.more_targets, words)
    saved = home.save_onikon(made, job.former, overwrites=command.overwrites)
    if isinstance(saved, Refusal):
        again = overwriting(saved, msgspec.structs.replace(command, overwrites=True), Reason.of("desk.replace_it"))
        return No(saved.reason, () if command.overwrites else again)
    text = Reason.of("desk.icon_made", name=name, what=job.says, kind=kind_named(made.type), path=str(saved.path))
    source = file_index.again(job.source, model.syntax)
    model = source.beside(model) if source else model  # what was saved just now is what the icon is judged by
    now = shown_at_once(model, saved.path, outside.site)
    gone = forgotten(job.former.value, description) if job.former else NOTHING
    lost = (page.Say("warning", gone, command.doc),) if gone else ()
    return Done(now, value=str(saved.path), says=(page.Say("success", text, command.doc), *lost))


def _drafted(model: Model, doc: str, outside: Services) -> Draft | No:
    """The draft of what is open and saved; else why there is none."""
    application = model.applications.get(doc)
    if application is not None:
        return application_icon.drafted(model, application, outside.site)
    document = model.documents.get(doc)
    if document is None:
        return closed(DocumentKind.CONFIGURATION)
    refused = _unsaved(document)
    if refused:
        return refused
    job = drafted(document, outside.site)
    if isinstance(job, Draft):
        others = differences(model, document.content.configuration, document.base, outside.site)
        warnings = (*others.values(), *job.warnings)
        return replace(job, warnings=warnings + (job.notes if model.settings.shows_warnings else ()))
    return No(Reason.of("desk.several_reasons", reasons=job))


def _unsaved(document: Document) -> No | None:
    if document.opened is None or document.base is None:
        reason = Reason.of("desk.job_of_no_file", name=document.name)
        return No(reason, (Remedy(Reason.of("desk.save_as"), show=ShowSaveAs()),))
    if document.is_dirty:
        reason = Reason.of("desk.job_of_unsaved", name=document.name)
        return No(
            reason,
            (
                Remedy(Reason.of("desk.save_it"), act.Save(document.id)),
                Remedy(Reason.of("desk.save_as"), show=ShowSaveAs()),
            ),
        )
    return None


def _view(draft: Draft) -> DraftView:
    former = draft.former.value if draft.former else None
    left, right = (str(edge) for edge in draft.edges)
    return DraftView(
        name=draft.name,
        type=draft.kind.type,
        left_edge=left,
        right_edge=right,
        warnings=draft.warnings,
        picture="".join(former.picture.rows) if former else "",
        description=former.description if former else "",
        path=str(draft.path),
    )
