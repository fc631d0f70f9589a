"""Worlds in the messages of Foxglove: shapes as scene updates, bodies as frames (docs.foxglove.dev, schemas).

The frame of a world is `WORLD`, that of its body 3 `WORLD/3`; every shape stands in the frame of its body.
"""

from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from typing import Any

import msgspec

_encode = msgspec.json.Encoder().encode
_ROW = 7
_WHEN, _NUMERAL = "\0when", "\0numeral"
"""Stand where the time and the numbers come; nothing is called so."""
_TIMELESS = _encode(_WHEN)
_THIN = 0.001
_LIT = "lit"
"""Under this key stands the name of each shape of a body that shines."""
_WIDE = 20.0
"""How wide a plane without end is drawn."""


def _object(title: str = "", **properties: Any) -> dict[str, Any]:
    named = {"title": title} if title else {}
    return {**named, "type": "object", "properties": properties}


_NUMBER, _TEXT, _WHOLE = {"type": "number"}, {"type": "string"}, {"type": "integer"}
_TIME = _object("time", sec=_WHOLE, nsec=_WHOLE)
_VECTOR = _object("foxglove.Vector3", x=_NUMBER, y=_NUMBER, z=_NUMBER)
_TURN = _object("foxglove.Quaternion", x=_NUMBER, y=_NUMBER, z=_NUMBER, w=_NUMBER)
_POSE = _object("foxglove.Pose", position=_VECTOR, orientation=_TURN)
_COLOR = _object("foxglove.Color", r=_NUMBER, g=_NUMBER, b=_NUMBER, a=_NUMBER)


def _list(items: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": items}


_TRANSFORM = _object(
    "foxglove.FrameTransform",
    timestamp=_TIME,
    parent_frame_id=_TEXT,
    child_frame_id=_TEXT,
    translation=_VECTOR,
    rotation=_TURN,
)
_NEVER = ("arrows", "lines", "triangles", "texts", "models")
"""What an entity must name, and no world of ours has."""
_SOLID = {"pose": _POSE, "size": _VECTOR, "color": _COLOR}
_ENTITY = _object(
    "foxglove.SceneEntity",
    timestamp=_TIME,
    frame_id=_TEXT,
    id=_TEXT,
    lifetime=_object("duration", sec=_WHOLE, nsec=_WHOLE),
    frame_locked={"type": "boolean"},
    metadata=_list(_object("foxglove.KeyValuePair", key=_TEXT, value=_TEXT)),
    cubes=_list(_object("foxglove.CubePrimitive", **_SOLID)),
    spheres=_list(_object("foxglove.SpherePrimitive", **_SOLID)),
    cylinders=_list(_object("foxglove.CylinderPrimitive", **_SOLID, bottom_scale=_NUMBER, top_scale=_NUMBER)),
    **dict.fromkeys(_NEVER, _list(_object())),
)
_DELETION = _object("foxglove.SceneEntityDeletion", timestamp=_TIME, type=_WHOLE, id=_TEXT)

FRAMES = "foxglove.FrameTransforms"
FRAMES_SCHEMA = _encode(_object(FRAMES, transforms=_list(_TRANSFORM)))
SCENE = "foxglove.SceneUpdate"
SCENE_SCHEMA = _encode(_object(SCENE, deletions=_list(_DELETION), entities=_list(_ENTITY)))


def frames(world: str, at_ns: int, rows: bytes) -> bytes:
    """The bodies of a world, from rows of position and quaternion (w first) as float32."""
    numbers = memoryview(rows).cast("f").tolist()
    if not numbers:
        return _encode({"transforms": []})
    form = _form(world, len(numbers) // _ROW).replace(_TIMELESS, _encode(_time(at_ns)))
    return form % tuple(_encode(numbers)[1:-1].split(b","))


@lru_cache(8)
def _form(world: str, count: int) -> bytes:
    """The same with places to fill in: thirty times a second everything would cost more than its numbers."""
    bodies = [
        {
            "timestamp": _WHEN,
            "parent_frame_id": world,
            "child_frame_id": f"{world}/{body}",
            "translation": dict.fromkeys("xyz", _NUMERAL),
            "rotation": dict.fromkeys("wxyz", _NUMERAL),
        }
        for body in range(count)
    ]
    return _encode({"transforms": bodies}).replace(b"%", b"%%").replace(_encode(_NUMERAL), b"%b")


def rows(body: bytes) -> list[list[float]]:
    """The other way round: position and quaternion (w first) of each body."""
    rows = []
    for transform in msgspec.json.decode(body)["transforms"]:
        place, turn = transform["translation"], transform["rotation"]
        rows.append([place["x"], place["y"], place["z"], turn["w"], turn["x"], turn["y"], turn["z"]])
    return rows


def scene(world: str, at_ns: int, shapes: Sequence[Mapping[str, Any]], lit: Collection[str] = ()) -> bytes:
    """The shapes of a world, those in `lit` shining; one entity for each body."""
    bodies: dict[int, dict[str, Any]] = {}
    for shape in shapes:
        number = int(shape["body"])
        if number not in bodies:
            bodies[number] = {
                "timestamp": _time(at_ns),
                "frame_id": f"{world}/{number}",
                "id": f"{world}/{number}",
                "lifetime": {"sec": 0, "nsec": 0},
                "frame_locked": True,
                "metadata": [],
                "cubes": [],
                "spheres": [],
                "cylinders": [],
                **{kind: [] for kind in _NEVER},
            }
        _add(bodies[number], shape, shape["name"] in lit)
    return _encode({"deletions": [], "entities": list(bodies.values())})


def lit(body: bytes) -> list[str]:
    """The other way round: the names of the shapes that shine."""
    entities = msgspec.json.decode(body)["entities"]
    return [word["value"] for entity in entities for word in entity["metadata"] if word["key"] == _LIT]


def shapes(body: bytes) -> list[dict[str, Any]]:
    """The other way round, as far as it goes: what has no name here is called by its body."""
    rows = []
    for entity in msgspec.json.decode(body)["entities"]:
        number = int(entity["id"].rpartition("/")[2])
        for kind, key in (("box", "cubes"), ("ellipsoid", "spheres"), ("cylinder", "cylinders")):
            rows += [_shape(f"{entity['id']} {key} {k}", number, kind, each) for k, each in enumerate(entity[key])]
    return rows


def _shape(name: str, body: int, kind: str, geometry: Mapping[str, Any]) -> dict[str, Any]:
    x, y, z = (geometry["size"][axis] / 2 for axis in "xyz")
    turn, color = geometry["pose"]["orientation"], geometry["color"]
    return {
        "name": name,
        "body": body,
        "kind": kind,
        "size": [x, z] if kind == "cylinder" else [x, y, z],
        "position": [geometry["pose"]["position"][axis] for axis in "xyz"],
        "quaternion": [turn[part] for part in "wxyz"],
        "rgba": [color[part] for part in "rgba"],
        "paint": "",
    }


def _add(entity: dict[str, Any], shape: Mapping[str, Any], is_lit: bool) -> None:
    if is_lit:
        entity["metadata"].append({"key": _LIT, "value": shape["name"]})
    sizes = [*shape["size"], 0.0, 0.0, 0.0]
    primitive = {"pose": _pose(shape), "color": _color(shape["rgba"], is_lit)}
    match shape["kind"]:
        case "sphere":
            entity["spheres"].append({**primitive, "size": _vector([2 * sizes[0]] * 3)})
        case "ellipsoid":
            entity["spheres"].append({**primitive, "size": _vector([2 * part for part in sizes[:3]])})
        case "cylinder" | "capsule":
            size = _vector([2 * sizes[0], 2 * sizes[0], 2 * sizes[1]])
            entity["cylinders"].append({**primitive, "size": size, "bottom_scale": 1.0, "top_scale": 1.0})
        case "plane":
            entity["cubes"].append(
                {**primitive, "size": _vector([2 * (sizes[0] or _WIDE), 2 * (sizes[1] or _WIDE), _THIN])}
            )
        case _:
            entity["cubes"].append({**primitive, "size": _vector([2 * part for part in sizes[:3]])})


def _pose(shape: Mapping[str, Any]) -> dict[str, Any]:
    w, i, j, k = shape["quaternion"]
    return {"position": _vector(shape["position"]), "orientation": {"x": i, "y": j, "z": k, "w": w}}


def _vector(parts: Sequence[float]) -> dict[str, float]:
    return dict(zip("xyz", parts, strict=True))


def _color(rgba: Sequence[float], is_lit: bool) -> dict[str, float]:
    if is_lit:
        return {"r": 1.0, "g": 0.9, "b": 0.2, "a": 1.0}
    return dict(zip("rgba", rgba, strict=True))


def _time(at_ns: int) -> dict[str, int]:
    return {"sec": at_ns // 1_000_000_000, "nsec": at_ns % 1_000_000_000}
