"""A URDF made such that it can be read: numbers, inertias, shapes and meshes; every repair is told (requirement X19).

What is repaired is what is wrong in published descriptions: of 141 of them 41 can be read as they are.
"""

import re
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from onika.store import collada_mesh
from onika.store.urdf_inertia import possible_inertia
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason

_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_SCHEME = re.compile(r"(package|model|file):/*")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_READ = (".stl", ".obj")
_COLLADA = ".dae"
_SHAPES = ("box", "cylinder", "sphere", "capsule")
_ROWS = ("xyz", "rpy", "size")
_ONCE = ("axis", "limit", "dynamics", "mimic", "origin", "parent", "child")
_KEPT = ("link", "joint", "material")
_DEEPEST = 8  # folders above a description in which a package is looked for
_COMPILER = {
    "strippath": "false",
    "discardvisual": "false",
    "fusestatic": "false",
    "boundmass": "1e-6",
    "boundinertia": "1e-9",
    "balanceinertia": "true",
}


ABSENT = ("store.urdf_no_mesh",)
"""Notes that a file is not there."""


@dataclass(frozen=True, slots=True)
class UrdfRepair:
    """A repaired description: its meshes by the names that it gives them, and what was repaired.

    converted   meshes in COLLADA, as OBJ
    """

    root: Element
    meshes: Mapping[str, Path]
    notes: tuple[Reason, ...]
    converted: Mapping[Path, bytes]

    def text(self, names: Mapping[str, str]) -> bytes:
        """The document with other names for its meshes."""
        for mesh in self.root.iter("mesh"):
            mesh.set("filename", names[mesh.get("filename", "")])
        text: str = ElementTree.tostring(self.root, encoding="unicode")
        return f'<?xml version="1.0"?>\n{text}\n'.encode()


def repaired(path: Path, dropped: Set[Path] = frozenset()) -> UrdfRepair:
    """The description at a path, without these meshes; raises ValueError with the reason where it is none."""
    notes: list[Reason] = []
    root = _document(path, path.read_text(encoding="utf-8", errors="replace"), notes)
    for element in [element for element in root if element.tag not in _KEPT]:
        root.remove(element)
    for joint in root.findall("joint"):
        _repair_joint(joint, notes)
    _refuse_ring(path, root)
    for named in root:
        notes += _repair_rows(named)
    moving = {child.get("link") for joint in root.findall("joint") if joint.get("type") != "fixed"
              for child in joint.findall("child")}  # fmt: skip
    meshes = _Meshes(path, dropped)
    for link in root.findall("link"):
        notes += _repair_shapes(link, meshes)
        notes += _repair_inertia(link, is_moving=link.get("name") in moving)
    ElementTree.SubElement(ElementTree.SubElement(root, "mujoco"), "compiler", _COMPILER)
    return UrdfRepair(root, meshes.found, tuple(dict.fromkeys(notes)), meshes.converted)


def _document(path: Path, text: str, notes: list[Reason]) -> Element:
    """The root of a document that need not be quite sound."""
    text = _COMMENT.sub("", text[max(text.find("<"), 0) :])
    if "<!ENTITY" in text:
        raise ValueError(Reason.of("store.entities"))
    attempts = (("", text), *_mended(text))
    why = ""
    for key, attempt in attempts:
        try:
            root = ElementTree.fromstring(attempt)  # noqa: S314 - without entities it is harmless
        except ElementTree.ParseError as wrong:
            why = why or str(wrong)
            continue
        if root.tag == "robot":
            notes += [Reason.of(key)] if key else []
            return root
        why = f"<{root.tag}>"
    raise ValueError(Reason.of("store.urdf_no_robot", path=str(path), why=why))


def _mended(text: str) -> Iterator[tuple[str, str]]:
    """The text with what is often wrong struck out, each with the key of what is told of it."""
    end = text.find("</robot>")
    if end >= 0:
        yield "store.urdf_behind", text[: end + len("</robot>")]
    plain = re.sub(r"\s\w+:(\w+)=", r" \1=", re.sub(r"<(/?)\w+:", r"<\1", text))
    yield "store.urdf_prefixes", plain
    printable = re.sub(r"[^\x09\x0a\x0d\x20-\x7e]", "", plain)
    yield "store.urdf_characters", re.sub(r"&(?!\w+;)", "&amp;", printable)


def _refuse_ring(path: Path, root: Element) -> None:
    """Raises ValueError where links stand on each other in a ring."""
    bearers = dict(_bearers(root))
    for link, bearer in bearers.items():
        ring, at = [link], bearer
        while at in bearers and at not in ring:
            ring.append(at)
            at = bearers[at]
        if at == link:
            why = Reason.of("store.urdf_root", links=tuple(ring))
            raise ValueError(Reason.of("store.robot_unreadable", place=str(path), reason=why))


def _bearers(root: Element) -> Iterator[tuple[str, str]]:
    """Each link that stands on another one, with that one."""
    for joint in root.findall("joint"):
        parent, child = joint.find("parent"), joint.find("child")
        if parent is not None and child is not None:
            yield child.get("link", ""), parent.get("link", "")


def _repair_joint(joint: Element, notes: list[Reason]) -> None:
    name = joint.get("name", "")
    for tag in _ONCE:
        for extra in joint.findall(tag)[1:]:
            joint.remove(extra)
            notes.append(Reason.of("store.urdf_second", joint=name, tag=tag))
    for tag in ("limit", "dynamics", "mimic"):
        for element in joint.findall(tag):
            notes += _repair_numbers(element, f"{name} {tag}")


def _repair_numbers(element: Element, where: str) -> Iterator[Reason]:
    """Attributes that are to be a number each."""
    for key in [key for key in element.attrib if key != "joint"]:
        given = element.attrib[key].strip()
        numbers = _NUMBER.findall(given)
        if len(numbers) != 1:
            del element.attrib[key]
            yield Reason.of("store.urdf_number", where=where, key=key)
            continue
        element.set(key, numbers[0])
        if numbers[0] != given:
            yield Reason.of("store.urdf_number_read", where=where, key=key, given=given, number=numbers[0])


def _repair_rows(named: Element) -> Iterator[Reason]:
    """Attributes that are to be three numbers each."""
    for element in named.iter():
        for key in (key for key in _ROWS if key in element.attrib):
            numbers = _NUMBER.findall(element.attrib[key])
            if len(numbers) != 3:
                where = f"{named.get('name', '')} {element.tag}"
                yield Reason.of("store.urdf_row", where=where, key=key, count=len(numbers), want=3)
            element.set(key, " ".join([*numbers, "0", "0", "0"][:3]))


def _repair_shapes(link: Element, meshes: "_Meshes") -> Iterator[Reason]:
    for shape in [*link.findall("visual"), *link.findall("collision")]:
        mesh = shape.find("geometry/mesh")
        reason = meshes.lacks(mesh) if mesh is not None else _shape_lacks(shape, link)
        if reason is not None:
            link.remove(shape)
            yield reason


def _shape_lacks(shape: Element, link: Element) -> Reason | None:
    geometry = shape.find("geometry")
    forms = [] if geometry is None else [form for form in geometry if form.tag in _SHAPES]
    sizes = [float(number) for form in forms[:1] for key in ("size", "radius", "length")
             for number in _NUMBER.findall(form.get(key, ""))]  # fmt: skip
    is_sound = bool(sizes) and min(sizes) > 0.0
    return None if is_sound else Reason.of("store.urdf_no_shape", link=link.get("name", ""))


class _Meshes:
    """The meshes of a description that can be used, by the names that it gives them, without those `dropped`."""

    def __init__(self, path: Path, dropped: Set[Path]) -> None:
        self._folder, self._dropped = path.resolve().parent, dropped
        self.found: dict[str, Path] = {}
        self.converted: dict[Path, bytes] = {}

    def lacks(self, mesh: Element) -> Reason | None:
        """Why a mesh cannot be used; None: it can, and is among the meshes."""
        name = mesh.get("filename", "")
        file = _file(name, self._folder)
        if file is None:
            return Reason.of("store.urdf_no_mesh", file=name)
        if file in self._dropped:
            return Reason.of("store.urdf_unusable", file=name)
        unread = self._unread(name, file)
        if unread is None:
            self.found[name] = file
        return unread

    def _unread(self, name: str, file: Path) -> Reason | None:
        """Why a mesh cannot be read; None: it can, one in COLLADA converted."""
        if file.suffix.lower() in _READ or file in self.converted:
            return None
        if file.suffix.lower() != _COLLADA:
            return Reason.of("store.urdf_no_reader", file=name)
        if not collada_mesh.can_read():
            return Reason.of("store.urdf_collada", file=name, extra=collada_mesh.EXTRA)
        try:
            self.converted[file] = collada_mesh.obj_of(file.read_bytes())
        except (OSError, ValueError) as wrong:
            why = system_reason(wrong) if isinstance(wrong, OSError) else reason_of(wrong)
            return Reason.of("store.urdf_collada_unread", file=name, why=why)
        return None


def _file(name: str, folder: Path) -> Path | None:
    """The file that a name means: of a package in this folder or one above, or beside the description."""
    plain = _SCHEME.sub("", name.strip())
    if not plain:
        return None
    if name.startswith("file:") and Path("/" + plain).is_file():
        return Path("/" + plain)
    tails = [tail for tail in (plain, plain.partition("/")[2]) if tail]
    above = [folder, *folder.parents][:_DEEPEST] if plain != name else [folder]
    places = ((where / tail).resolve() for where in above for tail in tails)
    return next((place for place in places if place.is_file()), None)


def _repair_inertia(link: Element, *, is_moving: bool) -> Iterator[Reason]:
    name = link.get("name", "")
    for extra in link.findall("inertial")[1:]:
        link.remove(extra)
        yield Reason.of("store.urdf_second", joint=name, tag="inertial")
    inertial = link.find("inertial")
    if inertial is None:
        if is_moving:
            yield Reason.of("store.urdf_no_mass", link=name)
        return
    mass, inertia = inertial.find("mass"), inertial.find("inertia")
    numbers = _NUMBER.findall(mass.get("value", "")) if mass is not None else []
    if mass is None or inertia is None or not numbers or float(numbers[0]) <= 0.0:
        link.remove(inertial)
        if is_moving:
            yield Reason.of("store.urdf_no_mass", link=name)
        return
    mass.set("value", numbers[0])
    if possible_inertia(inertia):
        yield Reason.of("store.urdf_inertia", link=name)
