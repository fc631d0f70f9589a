"""What is kept of a document that is not saved, so that it can be had back after a crash; as JSON."""

from dataclasses import asdict, dataclass, replace
from pathlib import Path

import msgspec

from onika.desk.environment.outcome.unread_faults import told
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.files import appl, conf, text
from onika.model.flow_path import numbered
from onika.model.syntax import Syntax
from onika.store.opened_text import Faults, OpenedText
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class RecoveryRecord:
    """A document.

    name    what it is called
    text    as a `.conf` or `.appl` file would hold it
    base    the base directory of its file; empty: it has none
    path    its file; empty: it has none
    former  what that file held when it was read or saved last
    kind    the ending of such files
    kept    configurations that are kept alive with it and have changed since they were saved
    """

    name: str
    text: str
    base: str = ""
    path: str = ""
    former: str = ""
    kind: str = conf.ENDING
    kept: tuple["RecoveryRecord", ...] = ()

    @property
    def every(self) -> tuple["RecoveryRecord", ...]:
        """It, then those that are kept alive with it: each comes back as a document of its own."""
        return replace(self, kept=()), *self.kept


def rescue_of(document: Document | OpenApplication) -> RecoveryRecord:
    """What is to be kept of a document."""
    opened = document.opened
    return RecoveryRecord(
        name=document.name,
        text=_text(document),
        kind=conf.ENDING if document.kind is DocumentKind.CONFIGURATION else appl.ENDING,
        base=str(document.base or ""),
        path=str(opened.path) if opened else "",
        former=opened.text if opened else "",
        kept=_kept(document) if isinstance(document, Document) else (),
    )


def write(record: RecoveryRecord) -> str:
    """As a file holds it."""
    return msgspec.json.encode(asdict(record)).decode() + "\n"


def read(content: str) -> RecoveryRecord:
    """What such a file holds; raises ValueError."""
    return msgspec.json.decode(content, type=RecoveryRecord)


def document_of(record: RecoveryRecord, doc: str, name: str = "") -> Document:
    """The document with the id `doc` as it was, and with another `name` where one is given; raises ValueError.

    It is as unsaved as it was; where its file has changed meanwhile, it says so.
    """
    name = name or record.name
    configuration, faults = conf.read(record.text, name, name)
    if configuration is None:
        raise ValueError(_all_of(faults))
    path = Path(record.path) if record.path else None
    former = conf.read(record.former, record.name, record.path)[0] if path else None
    opened = OpenedText(former, path, record.former) if path and former else None
    return Document(
        doc,
        Content(configuration),
        opened=opened,
        base=Path(record.base) if record.base else None,
        has_changed_on_disk=_has_changed(record),
    )


def application_of(record: RecoveryRecord, doc: str, syntax: Syntax, name: str = "") -> OpenApplication:
    """The same of an application; raises ValueError."""
    name = name or record.name
    application, faults = appl.salvage(record.text, name, name, syntax)
    if application is None:
        raise ValueError(_all_of(faults))
    application, last = numbered(application, 0)
    here = OpenApplication(doc, application, last, base=Path(record.base) if record.base else None)
    if not record.path:
        return here
    path = Path(record.path)
    former, wrong = appl.salvage(record.former, record.name, record.path, syntax)
    is_partial = appl.read(record.former, record.name, record.path, syntax)[0] is None
    return replace(
        here,
        opened=OpenedText(former, path, record.former) if former else None,
        file_faults=told(former, wrong, is_partial=is_partial) if former else (),
        is_partial=is_partial,
        has_changed_on_disk=_has_changed(record),
    )


def _all_of(faults: Faults) -> Reason:
    return Reason.of("run.faults_together", faults=tuple(fault.sentence for fault in faults))


def _text(document: Document | OpenApplication) -> str:
    if isinstance(document, Document):
        return conf.write(document.content.configuration)
    return appl.write(document.application)


def _kept(document: Document) -> tuple[RecoveryRecord, ...]:
    """Those that are kept alive with it and are not saved, as if each were open by itself."""
    return tuple(
        rescue_of(Document(document.id, Content(kept.configuration), opened=kept.opened, base=kept.base))
        for kept in document.content.kept
        if kept.is_unsaved
    )


def _has_changed(record: RecoveryRecord) -> bool:
    path = Path(record.path)
    return bool(record.path) and text.load(path, record.path)[0] != record.former
