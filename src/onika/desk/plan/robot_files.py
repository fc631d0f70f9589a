"""Of the model of a robot all that runs it: its description, a world, tasks, jobs and a small application (X19)."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from onika.desk.plan.robot_draft import drafted
from onika.desk.plan.robot_programs import PLACE, RobotPrograms
from onika.files import whole, world as world_file
from onika.model.world import CONES, ButtonBlock, PlaceBlock, WorldText
from onika.store.robot_package import RobotPackage, package
from onika.store.site import Site
from onika.wire.robot_draft import RobotDraft
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

LONGEST = 64
ENDINGS = (".xml", ".mjcf", ".urdf")

_BLOCKS = ("BASE", "ARM", "AXES", "GRIPPER", "CAMERA")
_USUAL, _FIRM = (CONES[0], 1.0), (CONES[1], 100.0)
_TRIES = 3  # a description without the meshes that cannot be used, once more without those that then cannot

Say = Callable[[Reason], str]


@dataclass(frozen=True, slots=True)
class NewRobot:
    """What was written, the application to begin with, and what was guessed, repaired or is lacking."""

    paths: tuple[Path, ...]
    tour: str
    notes: tuple[Reason, ...]


def create_robot(model: Path, base: Path, site: Site, name: str = "", say: Say = str) -> NewRobot:
    """Write all files of a robot into a base directory; raises ValueError with the reason why nothing was written.

    name   of the robot; empty: that of its model's file
    say    makes the words of the comments in its description
    """
    if model.suffix.lower() not in ENDINGS or not model.is_file():
        raise ValueError(Reason.of("desk.robot_no_file", path=str(model)))
    name = name or re.sub(r"\W+", "_", model.stem, flags=re.ASCII).strip("_")
    if not TASK_NAME.match(name) or not name.isidentifier() or len(name) > LONGEST:
        raise ValueError(Reason.of("desk.robot_name", longest=LONGEST, name=name))
    packed, draft = _drafted(model, base, name)
    programs = RobotPrograms(name, draft)
    texts = {
        f"robot/{name}.robot": _commented(draft, say),
        f"world/{name}.world": _world(name, draft),
        **dict(programs.texts()),
    }
    _refuse_present([*packed.contents, *texts], base, site)
    _write(base, packed.contents, texts)
    paths = tuple(base / path for path in (*packed.contents, *texts))
    return NewRobot(paths, programs.tour, (*packed.notes, *_guesses(draft), *draft.notes))


def _drafted(model: Path, base: Path, name: str) -> tuple[RobotPackage, RobotDraft]:
    """The model and its draft; meshes that cannot be used are dropped from a URDF, and an arm in MJCF gets motors."""
    dropped: set[Path] = set()
    undriven: tuple[str, ...] = ()
    for _ in range(_TRIES):
        packed = package(model, name, base, dropped, undriven)
        draft = drafted(packed.source, name, packed.file)
        if draft.undriven and not undriven:
            undriven = draft.undriven
            continue
        unusable = {packed.origins[file].resolve() for file in draft.unusable if file in packed.origins}
        if not draft.refusal or not unusable - dropped or model.suffix.lower() != ".urdf":
            break
        dropped |= unusable
    if draft.refusal:
        raise ValueError(_refusal(model, packed, draft.refusal))
    return packed, draft


def _refusal(model: Path, packed: RobotPackage, reason: Reason) -> Reason:
    """Why no robot can be made; what the model lacks comes first, for the rest may follow from that."""
    path = str(model)
    if packed.lacks:
        return Reason.of("desk.robot_lacks", path=path, lacks=packed.lacks, reason=reason)
    return Reason.of("desk.robot_refused", path=path, reason=reason)


def _guesses(draft: RobotDraft) -> tuple[Reason, ...]:
    """Where the lines of a description come from that the model does not say by itself."""
    return tuple(
        Reason.of("desk.robot_guess", line=" ".join(line.split()), reason=reason)
        for line, reason in _lines(draft)
        if reason is not None
    )


def _commented(draft: RobotDraft, say: Say) -> str:
    """The description with a comment before each line that was not simply read."""
    lines = [f"# {say(Reason.of('desk.robot_checks'))}\n"]
    for line, reason in _lines(draft):
        lines += [f"# {say(reason)}\n"] if reason is not None else []
        lines.append(line)
    return "".join(lines)


def _lines(draft: RobotDraft) -> Iterator[tuple[str, Reason | None]]:
    """Each line of a description with what is to be said of it."""
    comments = {(block, keyword): reason for block, keyword, reason in draft.comments}
    block = ""
    for line in draft.text.splitlines(keepends=True):
        keyword = line.partition(" ")[0].strip()
        block = keyword if keyword in _BLOCKS else block
        yield line, comments.get((block, keyword))


def _world(name: str, draft: RobotDraft) -> str:
    """A floor and the robot; where it has a gripper friction is firm, else what it holds would creep out of it."""
    contact = _FIRM if draft.opening else _USUAL
    blocks = (PlaceBlock(PLACE, (name,)), ButtonBlock(f"panic_{PLACE}", (PLACE,)))
    description = Reason.of("desk.robot_world", name=name).text
    return world_file.write(WorldText(name, description, contact=contact, floor=draft.floor, blocks=blocks))


def _refuse_present(paths: list[str], base: Path, site: Site) -> None:
    for path in paths:
        if (base / path).exists():
            raise ValueError(Reason.of("desk.file_there", path=str(base / path)))
    for directory in site.directories:
        taken = next((path for path in paths if (directory.path / path).exists()), None)
        if taken is not None:
            raise ValueError(Reason.of("desk.robot_taken", path=str(directory.path / taken)))


def _write(base: Path, contents: Mapping[str, bytes], texts: Mapping[str, str]) -> None:
    for path in (*contents, *texts):
        (base / path).parent.mkdir(parents=True, exist_ok=True)
    for path, content in contents.items():
        with (base / path).open("xb") as file:
            file.write(content)
    for path, text in texts.items():
        written = whole.write(base / path, text, whole.ABSENT)
        if isinstance(written, Refusal):
            raise ValueError(written.reason)
