"""A model, MJCF or URDF, made to stand alone: every file that it needs is called by its content (decision 49).

So a runtime needs no folder of the environment's, and two files of one name in two folders are two. Lines and columns
stay where they are but for the names of files.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from xml.parsers import expat

from onika.store import collada_mesh
from onika.store.opened_text import Faults
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason

MISSING = "missing"
"""What stands for a file that is not there; who reads the model leaves out what is made of it."""

LARGEST = 64 * 2**20
"""Bytes of the largest file that a model may need."""

_MESHES = (".stl", ".obj", ".msh", "")
"""Kinds of meshes that MuJoCo reads."""
_DIRECTORIES = ("meshdir", "texturedir", "assetdir")
_NAMED_BY_FILE = ("mesh", "texture", "hfield", "skin")
"""Elements that are called by their file where they have no name."""
_PACKAGE = re.compile(r"(package|model|file):/*")
_ATTRIBUTE = re.compile(rb"""(?P<key>[A-Za-z_:][\w:.-]*)\s*=\s*(?P<quote>["'])(?P<value>.*?)(?P=quote)""", re.DOTALL)
_DEEPEST = 8  # folders above a description in which a package is looked for


@dataclass(frozen=True, slots=True)
class Needed:
    """A file that a model needs, called by its content."""

    name: str
    path: Path
    content: bytes


@dataclass(frozen=True, slots=True)
class _Element:
    """The start of an element: what it is called, its attributes, where it begins in the bytes, and its line."""

    tag: str
    attributes: dict[str, str]
    at: int
    line: int


def self_contained(path: Path) -> tuple[bytes | None, tuple[Needed, ...], Faults]:
    """The model at a path with other names for its files, these files, and what is wrong; None: it cannot be read."""
    model = _Model(path)
    model.look(path, within=())
    content = model.rewritten(path, within=())
    return content, tuple(model.needed.values()), tuple(model.faults)


class _Model:
    """One model and the files that it includes."""

    def __init__(self, path: Path) -> None:
        self._folder = path.resolve().parent
        self._directories: dict[str, str] = {}
        self.needed: dict[str, Needed] = {}
        self.faults: list[Fault] = []

    def look(self, path: Path, within: tuple[Path, ...]) -> None:
        """Where files are looked for: what is said last counts for the whole document, with all that it includes."""
        try:
            elements = list(_elements(_content(path)))
        except (OSError, ValueError, expat.ExpatError):
            return  # told where it is rewritten
        for element in elements:
            file = self._found(element.tag, element.attributes.get("file", "")) if element.tag == "include" else None
            if element.tag == "compiler":
                said = {name: element.attributes[name] for name in _DIRECTORIES if name in element.attributes}
                self._directories |= said
            elif file is not None and file not in within:
                self.look(file, (*within, path, file))

    def rewritten(self, path: Path, within: tuple[Path, ...]) -> bytes | None:
        """A file of the model with other names for files; those that it includes are needed, rewritten too."""
        try:
            content = _content(path)
            elements = list(_elements(content))
        except OSError as error:
            self._fault(path, 0, Reason.of("files.unreadable", reason=system_reason(error)))
            return None
        except ValueError as wrong:
            self._fault(path, 0, Reason.plain(str(wrong)))
            return None
        except expat.ExpatError as wrong:
            self._fault(path, wrong.lineno, Reason.of("store.no_xml", why=expat.errors.messages[wrong.code]))
            return None
        changes = [change for element in elements for change in self._changes(element, content, path, within)]
        parts, end = [], 0
        for begin, stop, new in sorted(changes):
            parts += [content[end:begin], new]
            end = stop
        return b"".join([*parts, content[end:]])

    def _changes(
        self, element: _Element, content: bytes, path: Path, within: tuple[Path, ...]
    ) -> Iterator[tuple[int, int, bytes]]:
        """What is to be replaced in an element: where it begins, where it ends, and the new bytes."""
        end = content.index(b">", element.at)
        for match in _ATTRIBUTE.finditer(content, element.at, end):
            key, value = match["key"].decode(), element.attributes.get(match["key"].decode(), "")
            if element.tag == "compiler" and key in _DIRECTORIES:
                yield match.start("value"), match.end("value"), b""
            elif value and _is_reference(element.tag, key):
                name = self._name(element, key, value, path, within)
                yield match.start("value"), match.end("value"), name.encode()
        file = element.attributes.get("file", "")
        if element.tag in _NAMED_BY_FILE and file and not element.attributes.get("name"):
            after = element.at + 1 + len(element.tag)
            yield after, after, f' name="{Path(file).stem}"'.encode()

    def _name(self, element: _Element, key: str, value: str, path: Path, within: tuple[Path, ...]) -> str:
        """What a file is called from now on."""
        file = self._found(element.tag, value)
        if file is None:
            instead = Reason.of("store.made_of_it_left_out", tag=element.tag)
            self.faults.append(
                Fault(Place(str(path), element.line), Reason.of("store.model_file_gone", file=value), instead)
            )
            return MISSING + Path(value).suffix
        is_document = element.tag in ("include", "model")
        if is_document and file in within:
            self._fault(path, element.line, Reason.of("store.includes_itself", file=value))
            return MISSING + file.suffix
        try:
            content = self.rewritten(file, (*within, path, file)) if is_document else _content(file)
        except (OSError, ValueError) as wrong:
            why = system_reason(wrong) if isinstance(wrong, OSError) else Reason.plain(str(wrong))
            self._fault(path, element.line, Reason.of("files.unreadable", reason=why))
            return MISSING + file.suffix
        if content is None:
            return MISSING + file.suffix
        suffix = file.suffix.lower()
        if element.tag == "mesh" and suffix not in _MESHES:
            content, suffix = self._converted(element, path, file, content), ".obj"
            if content is None:
                return MISSING + suffix
        name = sha256(content).hexdigest()[:32] + suffix
        self.needed.setdefault(name, Needed(name, file, content))
        return name

    def _converted(self, element: _Element, path: Path, file: Path, content: bytes) -> bytes | None:
        """A mesh of a kind that MuJoCo does not read as one in OBJ; None where it cannot be, with what would help."""
        try:
            if file.suffix.lower() != collada_mesh.ENDING:
                raise ValueError(Reason.of("store.mesh_kind", file=file.name))
            if not collada_mesh.can_read():
                raise ValueError(Reason.of("store.collada_extra", file=file.name, extra=collada_mesh.EXTRA))
            return collada_mesh.obj_of(content)
        except ValueError as wrong:
            instead = Reason.of("store.made_of_it_left_out", tag=element.tag)
            self.faults.append(Fault(Place(str(path), element.line), reason_of(wrong), instead))
            return None

    def _found(self, tag: str, value: str) -> Path | None:
        """The file that a name means: in the folder that the model says, of a package in one above."""
        plain = _PACKAGE.sub("", value)
        if plain != value:
            return self._of_package(value, plain)
        directory = self._directories.get("texturedir" if tag == "texture" else "meshdir", "")
        directory = directory or self._directories.get("assetdir", "")
        folders = (self._folder,) if tag in ("include", "model") else (self._folder / directory, self._folder)
        return next((folder / plain for folder in folders if (folder / plain).is_file()), None)

    def _of_package(self, value: str, plain: str) -> Path | None:
        if value.startswith("file:") and Path("/" + plain).is_file():
            return Path("/" + plain)
        tails = (plain, plain.partition("/")[2])
        above = [self._folder, *self._folder.parents][:_DEEPEST]
        places = (folder / tail for folder in above for tail in tails if tail)
        return next((place for place in places if place.is_file()), None)

    def _fault(self, path: Path, line: int, reason: Reason) -> None:
        self.faults.append(Fault(Place(str(path), line), reason, Reason.of("words.file_left_out")))


def _is_reference(tag: str, key: str) -> bool:
    """Whether an attribute names a file."""
    return key == ("filename" if tag == "mesh" else "") or (key.startswith("file") and key != "filename")


def _content(path: Path) -> bytes:
    """Raises OSError, and ValueError for what is too large."""
    if path.stat().st_size > LARGEST:
        raise ValueError(Reason.of("files.too_large", size=path.stat().st_size, most=LARGEST))
    return path.read_bytes()


def _elements(content: bytes) -> Iterator[_Element]:
    """The elements of a document; raises ExpatError where it is none, ValueError where it defines entities."""
    elements: list[_Element] = []
    parser = expat.ParserCreate()

    def start(tag: str, attributes: dict[str, str]) -> None:
        elements.append(_Element(tag, attributes, parser.CurrentByteIndex, parser.CurrentLineNumber))

    def entity(*_: object) -> None:
        raise ValueError(Reason.of("store.entities"))

    parser.StartElementHandler = start
    parser.EntityDeclHandler = entity
    parser.Parse(content, True)
    yield from elements
