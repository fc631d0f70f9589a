"""The block CAMERA of worlds and robots (requirement F05)."""

from onika.files.block_words import BlockWords, number_row
from onika.files.line import row, show_number
from onika.files.text_reading import KeywordSlot, Need
from onika.model.camera import LENS_DEGREES, RATE_HZ, SIZE, CameraBlock
from onika.words.reason import Reason

HEAD = "CAMERA"
_KEYWORDS = ("VIEW", "ON", "AT", "LOOKS", "DEVICE", "LENS", "SIZE", "RATE")
SLOTS = (
    KeywordSlot(HEAD),
    *(KeywordSlot(keyword, Need.OPTIONAL) for keyword in _KEYWORDS),
)
_SMALLEST, _LARGEST = 16, 640
_SLOWEST_HZ, _FASTEST_HZ = 0.1, 30.0
_NARROWEST, _WIDEST = 1.0, 170.0


def camera(words: BlockWords) -> CameraBlock:
    """The camera of a block; what is wrong with its lines is told."""
    at = words.numbers("AT", Reason.of("files.three_metres"), 3)
    looks = words.numbers("LOOKS", Reason.of("files.three_metres"), 3)
    if words.has("AT") != words.has("LOOKS"):
        words.wrong("AT" if words.has("AT") else "LOOKS", Reason.of("files.at_and_looks"))
    elif at and at == looks:
        words.wrong("LOOKS", Reason.of("files.looks_at_itself"))
    _judge_kind(words)
    return CameraBlock(
        words.name(HEAD),
        words.word("VIEW", Reason.of("files.name_of_camera")),
        words.word("ON", Reason.of("files.name_of_body")),
        at,
        looks,
        _within(words, "LENS", LENS_DEGREES, (_NARROWEST, _WIDEST)),
        _size(words),
        _within(words, "RATE", RATE_HZ, (_SLOWEST_HZ, _FASTEST_HZ)),
        words.word("DEVICE", Reason.of("files.device_of_camera")),
        words.lines,
    )


def show(block: CameraBlock) -> str:
    """The lines of a camera."""
    parts = [row(HEAD, block.name)]
    parts += [row("VIEW", block.view)] if block.view else []
    parts += [row("ON", block.on)] if block.on else []
    parts += [number_row("AT", block.at), number_row("LOOKS", block.looks)] if block.at else []
    parts += [row("DEVICE", block.device)] if block.device else []
    parts += [number_row("LENS", (block.lens,))] if block.lens != LENS_DEGREES else []
    parts += [row("SIZE", *map(str, block.size))] if block.size != SIZE else []
    parts += [row("RATE", show_number(block.rate))] if block.rate != RATE_HZ else []
    return "".join(parts)


def _judge_kind(words: BlockWords) -> None:
    """It is one of the model, stands somewhere, or is a real one; lines of the others are told."""
    is_placed, is_real = words.has("AT"), words.has("DEVICE")
    if words.has("ON") and not is_placed:
        words.wrong("ON", Reason.of("files.only_with_at", keyword="ON"))
    if words.has("LENS") and not (is_placed or is_real):
        words.wrong("LENS", Reason.of("files.only_with_at", keyword="LENS"))
    if words.has("VIEW") and is_placed:
        words.wrong("VIEW", Reason.of("files.view_or_at"))
    if is_real and (words.has("VIEW") or is_placed):
        words.wrong("DEVICE", Reason.of("files.real_camera_alone"))


def _size(words: BlockWords) -> tuple[int, int]:
    meaning = Reason.of("files.width_and_height", least=_SMALLEST, most=_LARGEST)
    width, height = words.numbers("SIZE", meaning, 2, SIZE)
    if not all(part.is_integer() and _SMALLEST <= part <= _LARGEST for part in (float(width), float(height))):
        words.wrong("SIZE", Reason.of("files.size_outside", least=_SMALLEST, most=_LARGEST, width=width, height=height))
    return int(width), int(height)


def _within(words: BlockWords, keyword: str, default: float, bounds: tuple[float, float]) -> float:
    least, most = bounds
    value = words.number(keyword, Reason.of("files.number_within", least=least, most=most), default)
    if not least <= value <= most:
        words.wrong(keyword, Reason.of("files.value_outside", least=least, most=most, keyword=keyword, found=value))
    return value
