"""Whether a whole motion stays within the range of its joints."""

from onika.laws.frames import Array, Numbers
from onika.laws.sentence import joint_beyond

_NEARLY = 1e-9


def check_range(places: Array, low: Numbers, high: Numbers) -> None:
    """Raises ValueError with the first joint that one of the positions double[m,n] (rad, m) has beyond its range."""
    ranges = zip(places.min(axis=0), places.max(axis=0), low, high, strict=True)
    for joint, (least, most, bottom, top) in enumerate(ranges, 1):
        if least < bottom - _NEARLY or most > top + _NEARLY:
            beyond = most if most > top + _NEARLY else least
            raise ValueError(joint_beyond(joint, float(beyond), "rad", float(bottom), float(top)))
