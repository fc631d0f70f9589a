"""A camera as a file says: what it looks through, how large its pictures are, how many it takes (requirement F05)."""

from collections.abc import Mapping
from dataclasses import dataclass, field

SIZE = (320, 240)
RATE_HZ = 10.0
LENS_DEGREES = 45.0


def _no_lines() -> Mapping[str, int]:
    return {}


@dataclass(frozen=True, slots=True)
class CameraBlock:
    """A camera: one of the model, called `view`, one that stands at `at` and looks at the point `looks`, or a real one.

    device  of a real one: its number or path on the machine of the runtime, or a film or row of pictures there
    on      the body in whose frame `at` and `looks` are (m); empty: in the world, or in the middle of the robot's model
    lens    how much it sees from below to above (degrees), of one that stands at `at`, or is real
    size    width and height of a picture in pixels
    rate    pictures in a second
    """

    name: str
    view: str = ""
    on: str = ""
    at: tuple[float, ...] = ()
    looks: tuple[float, ...] = ()
    lens: float = LENS_DEGREES
    size: tuple[int, int] = SIZE
    rate: float = RATE_HZ
    device: str = ""
    lines: Mapping[str, int] = field(default_factory=_no_lines, compare=False, repr=False)
