"""The cell of small files with cameras: one above the cube, one at the quill of its arms."""

from kit.worlds.file_cells import CELL, ROBOT, WORLD, files_of
from onika.wire.world_source import WorldSource

ABOVE = "CAMERA above\nAT 0.6 -0.9 0.5\nLOOKS 0.6 -0.9 0.06\nLENS 30\nSIZE 64 48\nRATE 20\n"
HAND = "CAMERA eye\nON quill\nAT 0 0 0.1\nLOOKS 0 0 0\nSIZE 32 32\n"


def filmed(above: str = ABOVE, hand: str = HAND) -> WorldSource:
    """The files of the cell with these cameras."""
    return files_of(
        {
            **CELL,
            "world/cell.world": WORLD.replace("SHINES cube.cube", "SHINES table.board").replace("EOF", f"{above}EOF"),
            "robot/elbow.robot": ROBOT.replace("EOF", f"{hand}EOF"),
        }
    )
