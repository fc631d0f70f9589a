"""What is kept of a document that is not saved, so that it can be had back after a crash; as JSON."""

from dataclasses import asdict, dataclass
from pathlib import Path

import msgspec

from onika.desk.environment.content import Content
from onika.desk.environment.document import Document
from onika.files import conf, text
from onika.store.opened import Opened


@dataclass(frozen=True, slots=True)
class Rescue:
    """A document.

    name    what it is called
    text    as a `.conf` file would hold it
    base    the base directory of its file; empty: it has none
    path    its file; empty: it has none
    former  what that file held when it was read or saved last
    """

    name: str
    text: str
    base: str = ""
    path: str = ""
    former: str = ""


def rescue_of(document: Document) -> Rescue:
    """What is to be kept of a document."""
    opened = document.opened
    return Rescue(
        name=document.name,
        text=conf.write(document.content.configuration),
        base=str(document.base or ""),
        path=str(opened.path) if opened else "",
        former=opened.text if opened else "",
    )


def write(rescue: Rescue) -> str:
    """As a file holds it."""
    return msgspec.json.encode(asdict(rescue)).decode() + "\n"


def read(content: str) -> Rescue:
    """What such a file holds; raises ValueError."""
    return msgspec.json.decode(content, type=Rescue)


def document_of(rescue: Rescue, doc: str, name: str = "") -> Document:
    """The document with the id `doc` as it was, and with another `name` where one is given; raises ValueError.

    It is as unsaved as it was; where its file has changed meanwhile, it says so.
    """
    name = name or rescue.name
    configuration, faults = conf.read(rescue.text, name, name)
    if configuration is None:
        raise ValueError("; ".join(map(str, faults)))
    path = Path(rescue.path) if rescue.path else None
    former = conf.read(rescue.former, rescue.name, rescue.path)[0] if path else None
    opened = Opened(former, path, rescue.former) if path and former else None
    return Document(
        doc,
        Content(configuration),
        opened=opened,
        base=Path(rescue.base) if rescue.base else None,
        has_changed_on_disk=path is not None and text.load(path, str(path))[0] != rescue.former,
    )
