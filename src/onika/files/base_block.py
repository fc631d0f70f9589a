"""A base that drives, as a block in the file of a robot (requirement K04)."""

from onika.files.block_words import BlockWords, number_row
from onika.files.line import row, show_number
from onika.files.text_reading import KeywordSlot, Need
from onika.model.robot import RobotBase
from onika.words.reason import Reason

SLOTS = (
    KeywordSlot("BASE"),
    *(KeywordSlot(keyword, Need.OPTIONAL) for keyword in ("WHEELS", "SLIDES", "SPEED")),
)
_SHORTEST_M = 1e-4
_USUAL = RobotBase("").speed


def read_base(words: BlockWords) -> RobotBase:
    """The base of a block, on wheels or on slides."""
    wheels, sizes = words.named_numbers("WHEELS", Reason.of("files.wheels_words"), 2, (2,), _SHORTEST_M)
    slides = words.words("SLIDES", Reason.of("files.slides_words"), 3)
    if len(slides) > 3 or len(set(wheels)) < len(wheels):
        words.wrong("SLIDES" if slides else "WHEELS", Reason.of("files.base_moves_unlike"))
    if words.has("WHEELS") == words.has("SLIDES"):
        words.wrong("BASE", Reason.of("files.wheels_or_slides"))
    speed = words.numbers("SPEED", Reason.of("files.speed_and_turning"), 2, _USUAL, low=1e-6)
    radius, track = sizes or (0.0, 0.0)
    return RobotBase(words.name("BASE"), wheels, radius, track, slides, (speed[0], speed[1]), words.lines)


def show_base(base: RobotBase) -> str:
    """The lines of a base."""
    moves = row("SLIDES", *base.slides)
    if base.wheels:
        moves = row("WHEELS", *base.wheels, show_number(base.radius), show_number(base.track))
    return row("BASE", base.name) + moves + (number_row("SPEED", base.speed) if base.speed != _USUAL else "")
