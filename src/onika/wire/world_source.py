"""The files of a world on their way to a runtime: the world's own, its robots', their models', and what these need."""

from collections.abc import Iterable
from hashlib import sha256

from msgspec import Struct


class WorldFile(Struct, frozen=True):
    """One file. What a model needs, such as a mesh, is named by its content; the model refers to it by that name."""

    name: str
    """`world/NAME.world`, `robot/NAME.robot`, a model as its robot or world names it, or `DIGEST.ENDING`."""
    path: str
    """Where the environment read it; for messages."""
    content: bytes


class WorldSource(Struct, frozen=True):
    """All files of one world, named together by their content."""

    world: str
    digest: str
    """SHA-256 in hexadecimal of the names and contents."""
    files: tuple[WorldFile, ...]

    def find(self, name: str) -> WorldFile | None:
        """The file of this name."""
        return next((file for file in self.files if file.name == name), None)


def digest_of(files: Iterable[WorldFile]) -> str:
    """What names these files together; where they were read does not count."""
    digest = sha256()
    for file in files:
        for part in (file.name.encode(), file.content):
            digest.update(len(part).to_bytes(8, "little"))
            digest.update(part)
    return digest.hexdigest()
