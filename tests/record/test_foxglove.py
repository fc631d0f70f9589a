import json

import msgspec
import numpy as np
import pytest

from onika.record import foxglove

SHAPE = {
    "name": "lamp", "body": 2, "kind": "box", "size": (0.1, 0.2, 0.3), "position": (1.0, 2.0, 3.0),
    "quaternion": (1.0, 0.0, 0.0, 0.0), "rgba": (0.1, 0.2, 0.3, 1.0), "paint": "",
}  # fmt: skip


def fits(schema, value):
    """Whether a value is what its schema says, and has nothing that the schema does not know."""
    kinds = {"object": dict, "array": list, "number": int | float, "integer": int, "string": str, "boolean": bool}
    assert isinstance(value, kinds[schema["type"]]), (schema, value)
    if schema["type"] == "object":
        assert set(value) == set(schema["properties"]), (schema, value)  # every field is required of it
        for key, inner in value.items():
            fits(schema["properties"][key], inner)
    for inner in value if schema["type"] == "array" else ():
        fits(schema["items"], inner)
    return True


def test_bodies_are_frames_and_come_back():  # R-X05, K03: opens in Foxglove
    rows = np.array([[0, 0, 0, 1, 0, 0, 0], [0.5, 1, 1.5, 0, 1, 0, 0]], dtype=np.float32)
    body = foxglove.frames("boxes", 1_500_000_000, rows.tobytes())
    scene = json.loads(body)
    assert fits(json.loads(foxglove.FRAMES_SCHEMA), scene)
    assert scene["transforms"][1]["timestamp"] == {"sec": 1, "nsec": 500_000_000}
    assert (scene["transforms"][1]["parent_frame_id"], scene["transforms"][1]["child_frame_id"]) == ("boxes", "boxes/1")
    assert scene["transforms"][1]["rotation"] == {"x": 1.0, "y": 0.0, "z": 0.0, "w": 0.0}
    assert foxglove.rows(body) == rows.tolist()


@pytest.mark.parametrize(
    ("kind", "key", "size"),
    [
        ("box", "cubes", [0.2, 0.4, 0.6]),
        ("mesh", "cubes", [0.2, 0.4, 0.6]),
        ("sphere", "spheres", [0.2, 0.2, 0.2]),
        ("ellipsoid", "spheres", [0.2, 0.4, 0.6]),
        ("cylinder", "cylinders", [0.2, 0.2, 0.4]),
        ("capsule", "cylinders", [0.2, 0.2, 0.4]),
        ("plane", "cubes", [0.2, 0.4, 0.001]),
    ],
)
def test_every_shape_is_drawn_in_the_frame_of_its_body(kind, key, size):  # K03
    scene = json.loads(foxglove.scene("boxes", 0, [{**SHAPE, "kind": kind}]))
    assert fits(json.loads(foxglove.SCENE_SCHEMA), scene)
    (entity,) = scene["entities"]
    assert (entity["frame_id"], entity["frame_locked"]) == ("boxes/2", True)
    assert list(entity[key][0]["size"].values()) == pytest.approx(size)


def test_what_shines_is_yellow():
    dark, lit = (json.loads(foxglove.scene("w", 0, [SHAPE], names)) for names in ((), ("lamp",)))
    assert dark["entities"][0]["cubes"][0]["color"]["r"] == 0.1
    assert lit["entities"][0]["cubes"][0]["color"] == {"r": 1.0, "g": 0.9, "b": 0.2, "a": 1.0}


def test_what_shines_is_told_by_name():  # R-X05: 3-D in review
    dark, lit = (foxglove.scene("w", 0, [SHAPE], names) for names in ((), ("lamp",)))
    assert (foxglove.lit(dark), foxglove.lit(lit)) == ([], ["lamp"])
    assert fits(json.loads(foxglove.SCENE_SCHEMA), json.loads(lit))


@pytest.mark.parametrize(
    ("kind", "back", "size"),
    [("box", "box", [0.1, 0.2, 0.3]), ("sphere", "ellipsoid", [0.1] * 3), ("capsule", "cylinder", [0.1, 0.2])],
)
def test_shapes_come_back_as_far_as_they_are_drawn(kind, back, size):  # R-X05: recordings without shapes of their own
    (shape,) = foxglove.shapes(foxglove.scene("w", 0, [{**SHAPE, "kind": kind}]))
    assert (shape["body"], shape["kind"], shape["size"]) == (2, back, pytest.approx(size))
    assert (shape["position"], shape["quaternion"], shape["rgba"]) == ([1, 2, 3], [1, 0, 0, 0], [0.1, 0.2, 0.3, 1.0])


def test_a_world_may_be_called_what_it_likes_and_have_no_body():  # R-X05
    row = np.array([[1, 2, 3, 0.5, -0.5, 0.25, 1e-9]] * 2, dtype=np.float32).tobytes()
    for name in ("a%b", '"quoted"', "größe"):
        transforms = msgspec.json.decode(foxglove.frames(name, 2_000_000_003, row))["transforms"]
        assert [transform["parent_frame_id"] for transform in transforms] == [name, name]
        assert [transform["child_frame_id"] for transform in transforms] == [f"{name}/0", f"{name}/1"]
        assert transforms[0]["timestamp"] == {"sec": 2, "nsec": 3}
        assert transforms[1]["rotation"] == {"x": -0.5, "y": 0.25, "z": pytest.approx(1e-9), "w": 0.5}
    assert foxglove.rows(foxglove.frames("none", 0, b"")) == []
