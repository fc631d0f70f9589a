"""The files of robots and worlds, read naively from the tables of guide 7."""

from typing import Any

from .script import Script, blanks, name, one_of, one_word, real, words

AXES = ("x", "y", "z", "-x", "-y", "-z")
DRIVES = ("position", "velocity", "torque")


def robot(text: str) -> dict[str, Any]:
    script = _ours(text)
    result: dict[str, Any] = {"DESC": blanks(script.new("DESC") or ""), "FILE": _file(script.take("FILE"))}
    hand, on = script.new("HAND"), script.new("ON")
    if (hand is None) != (on is None):
        raise ValueError("HAND and ON")
    result["HAND"] = None if hand is None or on is None else (_file(hand), one_word(on))
    readers = {"ARM": _arm, "AXES": _axes, "GRIPPER": _gripper}
    devices = []
    while script.next in readers:
        kind = script.next
        devices.append((kind, name(script.take(kind)), readers[kind](script)))
    script.end()
    _once([device[1] for device in devices])
    _once([actuator for _, _, lines in devices for actuator in lines.get("MOVES", ())])
    return {**result, "devices": devices}


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
    readers = {"PART": _part, "PLACE": _place, "SWITCH": _switch, "LAMP": _lamp, "BUTTON": _button}
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
    armature = script.new("ARMATURE")
    arm["ARMATURE"] = None if armature is None else _from(armature, 0.0)
    return arm


def _axes(script: Script) -> dict[str, Any]:
    return {"MOVES": _names(script.take("MOVES")), "DRIVE": _drive(script)}


def _gripper(script: Script) -> dict[str, Any]:
    moves = _names(script.take("MOVES"))
    opened, closed = ([_number(word) for word in words(script.take(keyword))] for keyword in ("OPEN", "CLOSED"))
    if len(opened) != 2 or len(closed) != 2 or opened[0] == closed[0] or not opened[1] > closed[1] >= 0:
        raise ValueError("OPEN and CLOSED")
    force = script.new("FORCE")
    return {"MOVES": moves, "OPEN": opened, "CLOSED": closed, "FORCE": [] if force is None else _names(force)}


def _part(script: Script) -> dict[str, Any]:
    part: dict[str, Any] = {"FILE": _file(script.take("FILE")), **_spot(script)}
    free = script.new("FREE")
    if free is not None and len(words(free)) > 1:
        raise ValueError("FREE")
    part["FREE"] = None if free is None else _from(free or "0", 0.0)
    return part


def _place(script: Script) -> dict[str, Any]:
    return {"ROBOTS": [name(robot) for robot in _names(script.take("ROBOTS"))], **_spot(script)}


def _switch(script: Script) -> dict[str, Any]:
    near, pressed = script.new("NEAR"), script.new("PRESSED")
    if near is None and pressed is None:
        raise ValueError("SWITCH")
    result: dict[str, Any] = {"NEAR": None, "PRESSED": None}
    if near is not None:
        first, other, apart = words(near)
        result["NEAR"] = first, other, _from(apart, 0.0)
    if pressed is not None:
        sensor, force = words(pressed)
        result["PRESSED"] = sensor, _from(force, 0.0)
    return result


def _lamp(script: Script) -> dict[str, Any]:
    when, shines = _names(script.take("WHEN")), script.new("SHINES")
    return {"WHEN": when, "SHINES": [] if shines is None else _names(shines)}


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
        if lines.get("ON") and (not dot or not site or at not in names["PART"]):
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
    names = words(text)
    _once(names)
    if not 0 < len(names) <= 64:
        raise ValueError(text)
    return names


def _once(names: list[str]) -> None:
    if len(set(names)) < len(names):
        raise ValueError("twice")


def _file(text: str) -> str:
    if not blanks(text):
        raise ValueError("no file")
    return blanks(text)
