"""Values of the formats of robots and worlds, each field of each drawn."""

import string

from hypothesis import strategies as st

from onika.model.camera import CameraBlock
from onika.model.robot import (
    AXIS_WORDS,
    DRIVES,
    GRIPPER_DRIVES,
    RobotArm,
    RobotAxes,
    RobotBase,
    RobotGripper,
    RobotText,
    SensorBlock,
)
from onika.model.world import (
    CONES,
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
from onika.words.sentence import LANGUAGES

names = st.from_regex(r"[A-Za-z][A-Za-z0-9_-]{0,8}", fullmatch=True)
words = st.text(string.ascii_letters + string.digits + '#=".-+/:', min_size=1, max_size=8)
prose = st.text(string.ascii_letters + "é-", max_size=20).map(lambda text: " ".join(text.split()))
files = st.from_regex(r"[a-z]{1,5}(/[a-z]{1,5})?( [a-z]{1,3})?\.(xml|urdf)", fullmatch=True)
plain_files = st.from_regex(r"[a-z]{1,5}\.xml", fullmatch=True)
numbers = st.floats(-1e6, 1e6).map(lambda number: number + 0.0)
above = st.floats(1e-6, 1e6)
from_0 = st.floats(0.0, 1e6).map(lambda number: number + 0.0)
some_words = st.lists(words, min_size=1, max_size=3, unique=True).map(tuple)
vectors = st.tuples(numbers, numbers, numbers)
drives = st.sampled_from(DRIVES)
titles = st.dictionaries(st.sampled_from(LANGUAGES), prose.filter(bool)).map(lambda given: tuple(given.items()))


def _rows(of: st.SearchStrategy[float]) -> st.SearchStrategy[tuple[float, ...]]:
    return st.lists(of, max_size=4).map(tuple)


@st.composite
def _arms(draw: st.DrawFn, name: str) -> RobotArm:
    approach = draw(st.sampled_from(AXIS_WORDS))
    fingers = draw(st.sampled_from([axis for axis in AXIS_WORDS if axis[-1] != approach[-1]]))
    offset = draw(st.just((0.0, 0.0, 0.0)) | vectors)
    start, drive, armature = draw(st.just("") | words), draw(drives), draw(st.none() | from_0)
    rows = draw(_rows(numbers)), draw(_rows(above)), draw(_rows(above))
    some = st.lists(above, min_size=1, max_size=3).map(tuple)
    gains = draw(st.none() | st.tuples(some, some)) if drive == "torque" else None
    return RobotArm(name, draw(words), offset, approach, fingers, start, drive, *rows, armature, gains=gains)


@st.composite
def _grippers(draw: st.DrawFn, name: str, moves: tuple[str, ...]) -> RobotGripper:
    signals = draw(st.tuples(numbers, numbers).filter(lambda pair: pair[0] != pair[1]))
    closed, opened = draw(st.tuples(from_0, from_0).map(sorted).filter(lambda pair: pair[0] < pair[1]))
    force = draw(st.just(()) | some_words)
    drive = draw(st.sampled_from(GRIPPER_DRIVES))
    return RobotGripper(name, moves, (signals[0], opened), (signals[1], closed), force, drive=drive)


@st.composite
def _bases(draw: st.DrawFn, name: str) -> RobotBase:
    moves = tuple(f"{word}.{name}" for word in draw(st.lists(words, min_size=3, max_size=3, unique=True)))
    speed = draw(st.just(RobotBase("").speed) | st.tuples(above, above))
    if draw(st.booleans()):
        return RobotBase(name, slides=moves, speed=speed)
    return RobotBase(name, moves[:2], draw(st.floats(1e-4, 1e6)), draw(st.floats(1e-4, 1e6)), speed=speed)


def _sensors(name: str) -> st.SearchStrategy[SensorBlock]:
    return st.builds(SensorBlock, st.just(name), some_words) | st.builds(SensorBlock, st.just(name), body=words)


@st.composite
def _cameras(draw: st.DrawFn, name: str) -> CameraBlock:
    size = draw(st.just(CameraBlock("").size) | st.tuples(st.integers(16, 640), st.integers(16, 640)))
    rate = draw(st.just(CameraBlock("").rate) | st.floats(0.1, 30.0))
    if draw(st.booleans()):
        return CameraBlock(name, draw(st.just("") | words), size=size, rate=rate)
    lens = draw(st.just(CameraBlock("").lens) | st.floats(1.0, 170.0))
    if draw(st.booleans()):
        return CameraBlock(name, lens=lens, size=size, rate=rate, device=draw(words))
    at, looks = draw(st.tuples(vectors, vectors).filter(lambda pair: pair[0] != pair[1]))
    return CameraBlock(name, "", draw(st.just("") | words), at, looks, lens, size, rate)


@st.composite
def robots(draw: st.DrawFn) -> RobotText:
    titles = draw(st.lists(names, max_size=4, unique=True))
    cameras = (draw(_cameras(titles.pop())),) if titles and draw(st.booleans()) else ()
    devices = []
    for number, title in enumerate(titles):
        moves = tuple(f"{word}{number}" for word in draw(some_words))
        axes = st.builds(RobotAxes, st.just(title), st.just(moves), drives)
        devices.append(draw(_arms(title) | axes | _grippers(title, moves) | _bases(title) | _sensors(title)))
    hand = draw(st.just(("", "")) | st.tuples(files, words))
    links = draw(st.just(()) | st.lists(plain_files, min_size=1, max_size=3).map(tuple))
    on = hand[1] or (draw(words) if links else "")
    kind = draw(st.just("") | names)
    head = draw(files), draw(prose), hand[0], on
    return RobotText("r", *head, tuple(devices), links=links, cameras=cameras, given_kind=kind)


@st.composite
def worlds(draw: st.DrawFn) -> WorldText:
    heads = draw(st.lists(names, min_size=10, max_size=10, unique=True))
    parts = [heads[0], draw(st.sampled_from([UNNAMED, heads[1]]))][: draw(st.integers(0, 2))]
    on = st.just("") | (st.just(f"{parts[0]}.top") if len(parts) > 1 else st.just(""))
    ats = st.just((0.0,) * 4) | st.tuples(numbers, numbers, numbers, numbers)
    blocks: list[Block] = [
        PartBlock(
            part, draw(files), Spot(draw(ats), draw(on) if at else ""), draw(st.none() | from_0), names=draw(titles)
        )
        for at, part in enumerate(parts)
    ]
    robots = st.lists(names, min_size=1, max_size=3, unique=True).map(tuple)
    places = heads[2 : 2 + draw(st.integers(0, 2))]
    hands = st.none() | st.tuples(words, words)
    blocks += [
        PlaceBlock(
            place,
            draw(robots),
            Spot(draw(ats), draw(on)),
            is_empty=draw(st.booleans()),
            hand=draw(hands),
            names=draw(titles),
            hand_names=draw(titles),
        )
        for place in places
    ]
    near = st.tuples(words, words, from_0)
    switches = heads[4 : 4 + draw(st.integers(0, 2))]
    blocks += [
        draw(st.builds(SwitchBlock, st.just(switch), near, st.none() | st.tuples(words, from_0))) for switch in switches
    ]
    if switches:
        shapes = draw(st.just(()) | some_words), draw(st.just(()) | some_words)
        blocks.append(LampBlock(heads[6], tuple(switches), shapes[0], glows=shapes[1], names=draw(titles)))
    if places:
        blocks.append(ButtonBlock(heads[7], tuple(places)))
    if draw(st.booleans()):
        blocks.append(draw(_sensors(heads[8])))
    if draw(st.booleans()):
        blocks.append(draw(_cameras(heads[9])))
    contact = draw(st.tuples(st.sampled_from(CONES), st.floats(1e-3, 1e6)))
    step, gravity, floor = draw(st.floats(1e-4, 0.02)), draw(from_0), draw(st.none() | numbers)
    return WorldText("w", draw(prose), step, gravity, contact, floor, tuple(blocks))
