"""The file of a world, `world/NAME.world`: a format of our own (requirement X19)."""

from collections.abc import Iterable, Mapping

from onika.files import camera as camera_block, name_rows, sensor_block
from onika.files.block_words import BlockWords, number_row, text_row
from onika.files.layout import carry_comments
from onika.files.line import row, show_number, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.model.camera import CameraBlock
from onika.model.robot import Numbers, SensorBlock
from onika.model.world import (
    CONES,
    GRAVITY,
    STEP_S,
    UNNAMED,
    Block,
    ButtonBlock,
    LampBlock,
    PartBlock,
    PlaceBlock,
    Spot,
    SwitchBlock,
    WorldText,
)
from onika.words.fault import Fault
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

ENDING = ".world"

_SHORTEST_S, _LONGEST_S = 1e-4, 0.02
"""A step of physics; devices fall silent after 50 ms."""

_HEAD = (
    KeywordSlot("VERSION"),
    *(KeywordSlot(keyword, Need.OPTIONAL) for keyword in ("DESC", "STEP", "GRAVITY", "CONTACT", "FLOOR")),
)
_OF_SWITCHES = ("NEAR", "PRESSED", "ABOVE", "TOUCHED")
_SPOT = (KeywordSlot("AT", Need.OPTIONAL), KeywordSlot("ON", Need.OPTIONAL))
_SLOTS = {
    "PART": (KeywordSlot("PART"), KeywordSlot("FILE"), *_SPOT, KeywordSlot("FREE", Need.OPTIONAL), name_rows.slot()),
    "PLACE": (
        KeywordSlot("PLACE"),
        KeywordSlot("ROBOTS"),
        KeywordSlot("HAND", Need.OPTIONAL),
        *_SPOT,
        name_rows.slot(),
        name_rows.slot(name_rows.HAND_NAME),
    ),
    "SWITCH": (KeywordSlot("SWITCH"), *(KeywordSlot(keyword, Need.OPTIONAL) for keyword in _OF_SWITCHES)),
    "LAMP": (
        KeywordSlot("LAMP"),
        KeywordSlot("WHEN"),
        KeywordSlot("SHINES", Need.OPTIONAL),
        KeywordSlot("GLOWS", Need.OPTIONAL),
        name_rows.slot(),
    ),
    "BUTTON": (KeywordSlot("BUTTON"), KeywordSlot("STOPS")),
    "SENSOR": sensor_block.SLOTS,
    camera_block.HEAD: camera_block.SLOTS,
}


def read(text: str, name: str, place_file: str) -> tuple[WorldText | None, tuple[Fault, ...]]:
    """The world `name` of a text; with any fault it is left out."""
    reading = TextReading(place_file, Reason.of("files.world_left_out"))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, set(_SLOTS))
    words = BlockWords(head, _HEAD, reading)
    if reading.lines and not reading.is_extended:
        reading.fault(reading.lines[0].number, Reason.of("files.version_of_ours", extended=EXTENDED))
    step_s = words.number("STEP", Reason.of("files.step_of_physics", shortest=_SHORTEST_S, longest=_LONGEST_S), STEP_S)
    if not _SHORTEST_S <= step_s <= _LONGEST_S:
        words.wrong("STEP", Reason.of("files.step_outside", shortest=_SHORTEST_S, longest=_LONGEST_S, found=step_s))
    gravity = words.number("GRAVITY", Reason.of("files.number_from_0"), GRAVITY, 0.0)
    floor = words.number("FLOOR", Reason.of("files.a_height"), 0.0) if words.has("FLOOR") else None
    made = tuple(_block(BlockWords(block, _SLOTS[block[0].keyword], reading), block[0].keyword) for block in blocks)
    world = WorldText(name, words.text("DESC"), step_s, gravity, _contact(words), floor, made, words.lines)
    _check_twice(world, reading)
    _check_names(world, reading)
    _check_attachments(world, reading)
    return (None if reading.broken else world), reading.faults


def write(world: WorldText, former: str = "") -> str:
    """The text of a world, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED), text_row("DESC", world.description)]
    parts += [number_row("STEP", (world.step_s,))] if world.step_s != STEP_S else []
    parts += [number_row("GRAVITY", (world.gravity,))] if world.gravity != GRAVITY else []
    if world.contact != (CONES[0], 1.0):
        parts += [row("CONTACT", world.contact[0], show_number(world.contact[1]))]
    parts += [] if world.floor is None else [number_row("FLOOR", (world.floor,))]
    parts += ["\n" + _show(block) for block in world.blocks]
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _show(block: Block) -> str:
    match block:
        case PartBlock():
            free = "" if block.free is None else row("FREE", *([show_number(block.free)] if block.free else []))
            shown = row("PART", block.name) + row("FILE", block.file) + _show_spot(block.spot) + free
            return shown + name_rows.show_names(block.names)
        case PlaceBlock():
            return _show_place(block)
        case SwitchBlock():
            return _show_switch(block)
        case LampBlock():
            shines = row("SHINES", *block.shines) if block.shines else ""
            shines += row("GLOWS", *block.glows) if block.glows else ""
            return row("LAMP", block.name) + row("WHEN", *block.when) + shines + name_rows.show_names(block.names)
        case SensorBlock():
            return sensor_block.show_sensor(block)
        case CameraBlock():
            return camera_block.show(block)
    return row("BUTTON", block.name) + row("STOPS", *block.stops)


def _show_switch(switch: SwitchBlock) -> str:
    near = row("NEAR", *switch.near[:2], show_number(switch.near[2])) if switch.near else ""
    pressed = row("PRESSED", switch.pressed[0], show_number(switch.pressed[1])) if switch.pressed else ""
    above = ""
    if switch.above:
        sensor, bound, place = switch.above
        above = row("ABOVE", sensor, show_number(bound), *([str(place)] if place else []))
    return row("SWITCH", switch.name) + near + pressed + above + (row("TOUCHED") if switch.is_touched else "")


def _show_place(place: PlaceBlock) -> str:
    robots = row("ROBOTS", *([UNNAMED] if place.is_empty else []), *place.robots)
    hand = row("HAND", *place.hand) if place.hand else ""
    names = name_rows.show_names(place.names) + name_rows.show_names(place.hand_names, name_rows.HAND_NAME)
    return row("PLACE", place.name) + robots + hand + _show_spot(place.spot) + names


def _show_spot(spot: Spot) -> str:
    at = number_row("AT", spot.at) if any(spot.at) else ""
    return at + (row("ON", spot.on) if spot.on else "")


def _contact(words: BlockWords) -> tuple[str, float]:
    names, numbers = words.named_numbers("CONTACT", Reason.of("files.cone_and_ratio", cones=CONES), 1, (1,), 1e-3)
    if names and names[0] not in CONES:
        words.wrong("CONTACT", Reason.of("files.cone_unknown", cones=CONES, found=names[0]))
    return (names[0], numbers[0]) if names else (CONES[0], 1.0)


def _block(words: BlockWords, keyword: str) -> Block:
    match keyword:
        case "PART":
            return _part(words)
        case "PLACE":
            return _place(words)
        case "SWITCH":
            return _switch(words)
        case "LAMP":
            shines = words.words("SHINES", Reason.of("files.names_of_shapes"))
            when = words.words("WHEN", Reason.of("files.names_of_switches"))
            glows = words.words("GLOWS", Reason.of("files.names_of_shapes"))
            return LampBlock(words.name("LAMP"), when, shines, words.lines, glows, name_rows.read_names(words))
        case "SENSOR":
            return sensor_block.read_sensor(words)
        case camera_block.HEAD:
            return camera_block.camera(words)
    return ButtonBlock(words.name("BUTTON"), words.words("STOPS", Reason.of("files.names_of_places")), words.lines)


def _part(words: BlockWords) -> PartBlock:
    free = None
    if words.has("FREE"):
        _, shake = words.named_numbers("FREE", Reason.of("files.nothing_or_metres"), 0, (0, 1), 0.0)
        free = shake[0] if shake else 0.0
    names = name_rows.read_names(words)
    return PartBlock(words.name("PART", UNNAMED), words.file("FILE"), _spot(words), free, words.lines, names)


def _place(words: BlockWords) -> PlaceBlock:
    """A place; `-` before its robots says that nothing stands there before one is claimed."""
    given = words.words("ROBOTS", Reason.of("files.names_of_robots"))
    is_empty = given[:1] == (UNNAMED,)
    robots = given[1:] if is_empty else given
    if is_empty and not robots:
        words.wrong("ROBOTS", Reason.of("files.names_of_robots"))
    for robot in robots:
        if not TASK_NAME.match(robot):
            words.wrong("ROBOTS", Reason.of("files.no_name_of_robot", found=repr(robot)))
    hand, _ = words.named_numbers("HAND", Reason.of("files.robot_and_site"), 2, (0,))
    return PlaceBlock(
        words.name("PLACE", UNNAMED),
        robots,
        _spot(words),
        words.lines,
        is_empty,
        (hand[0], hand[1]) if hand else None,
        name_rows.read_names(words),
        name_rows.read_names(words, name_rows.HAND_NAME),
    )


def _spot(words: BlockWords) -> Spot:
    at = words.numbers("AT", Reason.of("files.place_and_turn"), 4, (0.0, 0.0, 0.0, 0.0))
    return Spot(at, words.word("ON", Reason.of("files.site_of_part")))


def _switch(words: BlockWords) -> SwitchBlock:
    sites, apart = words.named_numbers("NEAR", Reason.of("files.sites_and_distance"), 2, (1,), 0.0)
    sensor, force = words.named_numbers("PRESSED", Reason.of("files.sensor_and_force"), 1, (1,), 0.0)
    above, bound = words.named_numbers("ABOVE", Reason.of("files.sensor_and_bound"), 1, (1, 2))
    if not any(words.has(keyword) for keyword in _OF_SWITCHES):
        words.wrong("SWITCH", Reason.of("files.switch_without_contact"))
    near = (sites[0], sites[1], apart[0]) if sites else None
    return SwitchBlock(
        words.name("SWITCH"),
        near,
        (sensor[0], force[0]) if sensor else None,
        words.lines,
        (above[0], bound[0], _place_of_number(words, bound[1:])) if above else None,
        words.has("TOUCHED"),
    )


def _place_of_number(words: BlockWords, given: Numbers) -> int:
    """Which number of a sensor is meant, from 0."""
    place = given[0] if given else 0.0
    if place < 0.0 or place != int(place):
        words.wrong("ABOVE", Reason.of("files.sensor_and_bound"))
    return int(place)


def _check_twice(world: WorldText, reading: TextReading) -> None:
    """Each name once, among all blocks that have one; `-` as often as there are parts and places without any."""
    seen: set[str] = set()
    for block in world.blocks:
        if block.name and block.name in seen and block.name != UNNAMED:
            reading.fault(min(block.lines.values()), Reason.of("files.name_twice", name=block.name))
        seen.add(block.name)


def _check_names(world: WorldText, reading: TextReading) -> None:
    """Switches and places that other blocks name."""
    switches, places = {switch.name for switch in world.switches}, {place.name for place in world.places}
    for lamp in world.lamps:
        _known(lamp.when, switches, lamp.lines.get("WHEN", 0), reading)
    for button in world.buttons:
        _known(button.stops, places, button.lines.get("STOPS", 0), reading)


def _known(names: Iterable[str], there: set[str], number: int, reading: TextReading) -> None:
    for name in names:
        if name not in there:
            given = tuple(sorted(there)) or Reason.of("files.nothing")
            reading.fault(number, Reason.of("files.name_unknown", there=given, name=name))


def _check_attachments(world: WorldText, reading: TextReading) -> None:
    """What stands on a part, on which part it stands in the end: on one that is there, and never on itself."""
    standing: tuple[PartBlock | PlaceBlock, ...] = (*world.parts, *world.places)
    carriers: Mapping[str, str] = {
        block.name: block.spot.on.partition(".")[0] for block in world.parts if block.spot.on
    }
    parts = {part.name for part in world.parts}
    for block in standing:
        if not block.spot.on:
            continue
        carrier, _, site = block.spot.on.partition(".")
        if not site or carrier not in parts:
            there = tuple(sorted(parts - {UNNAMED, block.name})) or Reason.of("files.nothing")
            reading.fault(block.lines["ON"], Reason.of("files.no_such_part", parts=there, on=block.spot.on))
        elif isinstance(block, PartBlock) and _leads_back(block.name, carriers):
            reading.fault(block.lines["ON"], Reason.of("files.stands_on_itself", part=block.name))


def _leads_back(name: str, carriers: Mapping[str, str]) -> bool:
    at, seen = name, set[str]()
    while at in carriers and at not in seen:
        seen.add(at)
        at = carriers[at]
    return at == name and bool(seen)
