"""A configuration becomes a job: its type, its warnings, its picture and its file (requirement C16, §5.6.2)."""

from dataclasses import replace

from onika.desk.environment.document import Document
from onika.desk.environment.draft import Draft, drafted
from onika.desk.environment.model import Model
from onika.desk.environment.on_document import closed
from onika.desk.environment.outcome import Done, No
from onika.desk.environment.remedy import plain
from onika.desk.environment.surroundings import Surroundings
from onika.model.onikon import Onikon
from onika.model.picture import BLACK, SIZE, Picture, framed
from onika.wire import act, page
from onika.wire.view import DraftView, Remedy
from onika.words.fault import Refusal


def draft(model: Model, asked: act.Draft, outside: Surroundings) -> Done | No:
    """What job a configuration would make; the value is a `view.DraftView`."""
    found = _drafted(model, asked.doc, outside)
    return found if isinstance(found, No) else Done(model, value=_view(found))


def make_job(model: Model, asked: act.MakeJob, outside: Surroundings) -> Done | No:
    """Save the onikon of a configuration beside it; the value is the path of its file."""
    found = _drafted(model, asked.doc, outside)
    if isinstance(found, No):
        return found
    picture = _picture(asked.picture)
    if isinstance(picture, str):
        return No(f"the picture cannot be kept: {picture}", fields={"picture": picture})
    name, path = found.name, found.path
    if path.exists() and not asked.overwrites:
        meant = act.MakeJob(asked.doc, asked.picture, asked.description, overwrites=True)
        return No(found.taken or f"{path} is there already", (Remedy("Replace it", meant),))
    made = Onikon(name, found.kind.type, " ".join(asked.description.split()), (), picture, found.kind.more_targets)
    saved = found.home.save_onikon(made, found.former, overwrites=asked.overwrites)
    if isinstance(saved, Refusal):
        meant = act.MakeJob(asked.doc, asked.picture, asked.description, overwrites=True)
        return No(plain(saved.reason), () if asked.overwrites else (Remedy("Replace it", meant),))
    text = f"{name} is a job now: {made.type}, in {saved.path}"
    return Done(model, value=str(saved.path), says=(page.Say("success", text, asked.doc),))


def _drafted(model: Model, doc: str, outside: Surroundings) -> Draft | No:
    """The draft of a document that is saved; else why there is none."""
    document = model.documents.get(doc)
    if document is None:
        return closed()
    unsaved = _unsaved(document)
    if unsaved:
        return unsaved
    found = drafted(document, outside.site)
    if isinstance(found, Draft):
        edited = [name for name in document.content.names if name in model.shelf.edits]
        text = "{} was changed here and is not saved: the job runs what its file says"
        warnings = (*(text.format(name) for name in edited), *found.warnings)
        return replace(found, warnings=warnings + (found.notes if model.habits.shows_warnings else ()))
    return No("; ".join(found))


def _unsaved(document: Document) -> No | None:
    if document.opened is None or document.base is None:
        reason = f"{document.name} has no file yet: a job is made of one"
        return No(reason, (Remedy("Save as…", show="save-as"),))
    if document.is_dirty:
        reason = f"{document.name} has changed since it was saved: a job is made of what its file says"
        return No(reason, (Remedy("Save it", act.Save(document.id)), Remedy("Save as…", show="save-as")))
    return None


def _view(found: Draft) -> DraftView:
    former = found.former.value if found.former else None
    left, right = (str(edge) for edge in found.edges)
    return DraftView(
        name=found.name,
        type=found.kind.type,
        left_edge=left,
        right_edge=right,
        warnings=found.warnings,
        picture="".join(former.picture.rows) if former else "",
        description=former.description if former else "",
        path=str(found.path),
    )


def _picture(digits: str) -> Picture | str:
    """The picture of 1024 digits, its border made black; a 9 is black too (decision 38). Else what is wrong."""
    if len(digits) != SIZE * SIZE or not (digits.isascii() and digits.isdigit()):
        strange = sorted({one for one in digits if not (one.isascii() and one.isdigit())})
        found = f"{len(digits)} signs" + (f", among them {strange[0]!r}" if strange else "")
        return f"expected {SIZE * SIZE} digits from 0 to 8, found {found}"
    rows = digits.replace("9", BLACK)
    return framed([rows[start : start + SIZE] for start in range(0, len(rows), SIZE)])
