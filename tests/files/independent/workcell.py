"""The files of robots and worlds, read naively from the tables of guide 7."""

from typing import Any

from .script import Script, blanks, name, one_of, one_word, real, words

AXES = ("x", "y", "z", "-x", "-y", "-z")
DRIVES = ("position", "velocity", "torque")


def robot(text: str) -> dict[str, Any]:
    script = _ours(text)
    result: dict[str, Any] = {"DESC": blanks(script.new("DESC") or "")}
    kind = script.new("KIND")
    result["KIND"] = "" if kind is None else name(kind)
    result["FILE"] = _file(script.take("FILE"))
    links, hand, on = script.new("LINKS"), script.new("HAND"), script.new("ON")
    if (links is None and hand is None) != (on is None):
        raise ValueError("HAND or LINKS, and ON")
    result["LINKS"] = [] if links is None else _many(links)
    result["HAND"] = "" if hand is None else _file(hand)
    result["ON"] = "" if on is None else one_word(on)
    readers = {
        "ARM": _arm, "AXES": _axes, "GRIPPER": _gripper, "BASE": _base, "SENSOR": _sensor, "CAMERA": _camera
    }  # fmt: skip
    blocks = []
    while script.next in readers:
        kind = script.next
        blocks.append((kind, name(script.take(kind)), readers[kind](script)))
    script.end()
    _once([block[1] for block in blocks])
    driven = [lines.get("MOVES") or lines.get("WHEELS") or lines.get("SLIDES") or [] for _, _, lines in blocks]
    _once([actuator for actuators in driven for actuator in actuators])
    result["CAMERAS"] = [block for block in blocks if block[0] == "CAMERA"]
    return {**result, "devices": [block for block in blocks if block[0] != "CAMERA"]}


def world(text: str) -> dict[str, Any]:
    script = _ours(text)
    result: dict[str, Any] = {"DESC": blanks(script.new("DESC") or "")}
    step, gravity, contact = script.new("STEP"), script.new("GRAVITY"), script.new("CONTACT")
    floor = script.new("FLOOR")
    result["STEP"] = 0.002 if step is None else _from(step, 1e-4)
    if result["STEP"] > 0.02:
        raise ValueError("STEP")
    result["GRAVITY"] = 9.81 if gravity is None else _from(gravity, 0.0)
    cone, ratio = ("pyramidal", "1") if contact is None else words(contact)
    result["CONTACT"] = one_of(cone, "pyramidal", "elliptic"), _from(ratio, 1e-3)
    result["FLOOR"] = None if floor is None else _number(floor)
    readers = {
        "PART": _part, "PLACE": _place, "SWITCH": _switch, "LAMP": _lamp, "BUTTON": _button,
        "SENSOR": _sensor, "CAMERA": _camera,
    }  # fmt: skip
    blocks = []
    while script.next in readers:
        kind = script.next
        title = script.take(kind)
        unnamed = title == "-" and kind in ("PART", "PLACE")
        blocks.append((kind, title if unnamed else name(title), readers[kind](script)))
    script.end()
    _judge(blocks)
    return {**result, "blocks": blocks}


def _ours(text: str) -> Script:
    script = Script(text, extended=True)
    if not script.is_new:
        raise ValueError("version")
    return script


def _arm(script: Script) -> dict[str, Any]:
    tool, *offset = words(script.take("TOOL"))
    if len(offset) not in (0, 3):
        raise ValueError("TOOL")
    arm: dict[str, Any] = {"TOOL": (tool, [_number(word) for word in offset] or [0.0, 0.0, 0.0])}
    approach, fingers = script.new("APPROACH"), script.new("FINGERS")
    arm["APPROACH"] = one_of("z" if approach is None else approach, *AXES)
    arm["FINGERS"] = one_of("y" if fingers is None else fingers, *AXES)
    if arm["APPROACH"][-1] == arm["FINGERS"][-1]:
        raise ValueError("axes")
    start = script.new("FROM")
    arm["FROM"] = "" if start is None else one_word(start)
    arm["DRIVE"] = _drive(script)
    for keyword, low in (("HOME", -1e9), ("SPEED", 1e-6), ("TORQUE", 1e-6)):
        line = script.new(keyword)
        arm[keyword] = [] if line is None else _some([_from(word, low) for word in words(line)])
    arm["GAINS"] = _gains(script, arm["DRIVE"])
    armature = script.new("ARMATURE")
    arm["ARMATURE"] = None if armature is None else _from(armature, 0.0)
    return arm


def _gains(script: Script, drive: str) -> tuple[list[float], list[float]] | None:
    stiffness, damping = script.new("KP"), script.new("KD")
    if stiffness is None and damping is None:
        return None
    if stiffness is None or damping is None or drive != "torque":
        raise ValueError("gains")
    of_each, against_each = ([_from(word, 1e-6) for word in words(line)] for line in (stiffness, damping))
    return _some(of_each), _some(against_each)


def _axes(script: Script) -> dict[str, Any]:
    return {"MOVES": _names(script.take("MOVES")), "DRIVE": _drive(script)}


def _gripper(script: Script) -> dict[str, Any]:
    moves, drive = _names(script.take("MOVES")), script.new("DRIVE")
    taken = one_of("opening" if drive is None else drive, "opening", "signal")
    opened, closed = ([_number(word) for word in words(script.take(keyword))] for keyword in ("OPEN", "CLOSED"))
    if len(opened) != 2 or len(closed) != 2 or opened[0] == closed[0] or not opened[1] > closed[1] >= 0:
        raise ValueError("OPEN and CLOSED")
    force = script.new("FORCE")
    return {
        "MOVES": moves,
        "DRIVE": taken,
        "OPEN": opened,
        "CLOSED": closed,
        "FORCE": [] if force is None else _names(force),
    }


def _base(script: Script) -> dict[str, Any]:
    wheels, slides, speed = script.new("WHEELS"), script.new("SLIDES"), script.new("SPEED")
    if (wheels is None) == (slides is None):
        raise ValueError("WHEELS or SLIDES")
    base: dict[str, Any] = {"WHEELS": [], "SIZES": (0.0, 0.0), "SLIDES": []}
    if wheels is not None:
        left, right, radius, track = words(wheels)
        base |= {"WHEELS": [left, right], "SIZES": (_from(radius, 1e-4), _from(track, 1e-4))}
        _once([left, right])
    if slides is not None:
        base["SLIDES"] = _names(slides)
        if len(base["SLIDES"]) != 3:
            raise ValueError("SLIDES")
    along, turning = ("0.5", "2") if speed is None else words(speed)
    return {**base, "SPEED": (_from(along, 1e-6), _from(turning, 1e-6))}


def _sensor(script: Script) -> dict[str, Any]:
    reads, body = script.new("READS"), script.new("POSE")
    if (reads is None) == (body is None):
        raise ValueError("READS or POSE")
    return {"READS": [] if reads is None else _names(reads), "POSE": "" if body is None else one_word(body)}


def _camera(script: Script) -> dict[str, Any]:
    view, on, at, looks, device = (script.new(keyword) for keyword in ("VIEW", "ON", "AT", "LOOKS", "DEVICE"))
    lens, size, rate = (script.new(keyword) for keyword in ("LENS", "SIZE", "RATE"))
    if (at is None) != (looks is None) or (at is not None and view is not None):
        raise ValueError("AT and LOOKS")
    if at is None and (on is not None or (lens is not None and device is None)):
        raise ValueError("only with AT")
    if device is not None and (view is not None or at is not None):
        raise ValueError("DEVICE")
    places = [[] if line is None else [_number(word) for word in words(line)] for line in (at, looks)]
    if at is not None and (any(len(place) != 3 for place in places) or places[0] == places[1]):
        raise ValueError("AT and LOOKS")
    width, height = (320.0, 240.0) if size is None else [_from(word, 16) for word in words(size)]
    if max(width, height) > 640 or width % 1 or height % 1:
        raise ValueError("SIZE")
    camera: dict[str, Any] = {"VIEW": "" if view is None else one_word(view), "ON": "" if on is None else one_word(on)}
    camera["DEVICE"] = "" if device is None else one_word(device)
    camera |= {"AT": places[0], "LOOKS": places[1], "SIZE": (int(width), int(height))}
    camera["LENS"] = 45.0 if lens is None else _from(lens, 1.0)
    camera["RATE"] = 10.0 if rate is None else _from(rate, 0.1)
    if camera["LENS"] > 170 or camera["RATE"] > 30:
        raise ValueError("LENS or RATE")
    return camera


def _part(script: Script) -> dict[str, Any]:
    part: dict[str, Any] = {"FILE": _file(script.take("FILE")), **_spot(script)}
    free = script.new("FREE")
    if free is not None and len(words(free)) > 1:
        raise ValueError("FREE")
    part["FREE"] = None if free is None else _from(free or "0", 0.0)
    return {**part, "NAME": _titles(script, "NAME")}


def _titles(script: Script, keyword: str) -> dict[str, str]:
    titles: dict[str, str] = {}
    while (line := script.new(keyword)) is not None:
        language, *title = words(line)
        if language not in ("en", "es") or language in titles or not title:
            raise ValueError(keyword)
        titles[language] = " ".join(title)
    return titles


def _place(script: Script) -> dict[str, Any]:
    robots, hand = _names(script.take("ROBOTS")), script.new("HAND")
    is_empty = robots[0] == "-"
    place: dict[str, Any] = {"EMPTY": is_empty, "ROBOTS": [name(robot) for robot in robots[is_empty:]]}
    if not place["ROBOTS"]:
        raise ValueError("ROBOTS")
    place["HAND"] = None if hand is None else words(hand)
    if hand is not None and len(words(hand)) != 2:
        raise ValueError("HAND")
    return {**place, **_spot(script), "NAME": _titles(script, "NAME"), "HANDNAME": _titles(script, "HANDNAME")}


def _switch(script: Script) -> dict[str, Any]:
    near, pressed, above, touched = (script.new(keyword) for keyword in ("NEAR", "PRESSED", "ABOVE", "TOUCHED"))
    if near is None and pressed is None and above is None and touched is None:
        raise ValueError("SWITCH")
    result: dict[str, Any] = {"NEAR": None, "PRESSED": None, "ABOVE": None, "TOUCHED": touched is not None}
    if near is not None:
        first, other, apart = words(near)
        result["NEAR"] = first, other, _from(apart, 0.0)
    if pressed is not None:
        sensor, force = words(pressed)
        result["PRESSED"] = sensor, _from(force, 0.0)
    if above is not None:
        sensor, bound, *place = words(above)
        if len(place) > 1 or (place and (_from(place[0], 0.0) != int(_from(place[0], 0.0)))):
            raise ValueError("ABOVE")
        result["ABOVE"] = sensor, _from(bound, -1e9), int(_from(place[0], 0.0)) if place else 0
    return result


def _lamp(script: Script) -> dict[str, Any]:
    when, shines, glows = _names(script.take("WHEN")), script.new("SHINES"), script.new("GLOWS")
    shapes = [[] if line is None else _names(line) for line in (shines, glows)]
    return {"WHEN": when, "SHINES": shapes[0], "GLOWS": shapes[1], "NAME": _titles(script, "NAME")}


def _button(script: Script) -> dict[str, Any]:
    return {"STOPS": _names(script.take("STOPS"))}


def _spot(script: Script) -> dict[str, Any]:
    at, on = script.new("AT"), script.new("ON")
    numbers = [0.0] * 4 if at is None else [_number(word) for word in words(at)]
    if len(numbers) != 4:
        raise ValueError("AT")
    return {"AT": numbers, "ON": "" if on is None else one_word(on)}


def _judge(blocks: list[tuple[str, str, dict[str, Any]]]) -> None:
    _once([title for _, title, _ in blocks if title != "-"])
    names = {kind: {title for of, title, _ in blocks if of == kind} for kind in ("PART", "PLACE", "SWITCH")}
    for kind, title, lines in blocks:
        if set(lines.get("WHEN", ())) - names["SWITCH"] or set(lines.get("STOPS", ())) - names["PLACE"]:
            raise ValueError("unknown")
        at, dot, site = lines.get("ON", "").partition(".")
        if kind != "CAMERA" and lines.get("ON") and (not dot or not site or at not in names["PART"]):
            raise ValueError("ON")
        if kind == "PART":
            _stands({of: on["ON"].partition(".")[0] for of_kind, of, on in blocks if of_kind == "PART"}, title)


def _stands(carriers: dict[str, str], title: str) -> None:
    at = title
    for _ in carriers:
        at = carriers.get(at, "")
        if at == title:
            raise ValueError("on itself")


def _drive(script: Script) -> str:
    drive = script.new("DRIVE")
    return one_of("position" if drive is None else drive, *DRIVES)


def _number(text: str) -> float:
    return _from(text, -1e9)


def _from(text: str, low: float) -> float:
    number = real(text)
    if not low <= number <= 1e9:
        raise ValueError(text)
    return number


def _some(numbers: list[float]) -> list[float]:
    if not 0 < len(numbers) <= 64:
        raise ValueError("numbers")
    return numbers


def _names(text: str) -> list[str]:
    _once(_many(text))
    return words(text)


def _many(text: str) -> list[str]:
    if not 0 < len(words(text)) <= 64:
        raise ValueError(text)
    return words(text)


def _once(names: list[str]) -> None:
    if len(set(names)) < len(names):
        raise ValueError("twice")


def _file(text: str) -> str:
    if not blanks(text):
        raise ValueError("no file")
    return blanks(text)
