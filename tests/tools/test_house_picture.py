"""The picture of the house shows every package, with its files, and arrows that the imports bear out."""

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

import house_picture

ROOT = Path(__file__).parents[2]
SVG = "{http://www.w3.org/2000/svg}"
FLOORS = """\
[[tool.importlinter.contracts]]
id = "floors"
layers = ["cli", "desk | host", "words"]
"""


@pytest.fixture
def drawn(tmp_path):
    """Draws a small house of the given files."""

    def draw(**files):
        (tmp_path / "pyproject.toml").write_text(FLOORS)
        for name, text in {
            "__init__": "",
            "cli/run": "",
            "desk/plan": "",
            "host/run": "",
            "words/key": "",
            **files,
        }.items():
            path = tmp_path / "src/onika" / f"{name}.py"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return ET.fromstring(house_picture.picture(tmp_path))

    return draw


def words(image):
    return [text.text for text in image.iter(f"{SVG}text")][:-1]


def arrows(image, kind="use"):
    return len(image.findall(f"{SVG}path[@class='{kind}']"))


def height(image, name):
    return next(float(text.get("y")) for text in image.iter(f"{SVG}text") if text.text == name)


def test_every_room_stands_on_its_floor_with_its_files(drawn):
    image = drawn(**{"host/clock": ""})
    assert words(image) == ["cli", "1 file", "desk", "1 file", "host", "2 files", "words", "1 file"]
    assert height(image, "cli") < height(image, "desk") == height(image, "host") < height(image, "words")


def test_an_arrow_that_follows_from_others_is_left_out(drawn):
    to_words = "from onika.words import key\n"
    image = drawn(**{"cli/run": f"import onika.desk.plan\n{to_words}", "desk/plan": to_words})
    assert arrows(image) == 2


def test_an_import_inside_a_function_is_an_arrow(drawn):
    assert arrows(drawn(**{"cli/run": "def run():\n    import onika.host.run\n"})) == 1


def test_rooms_within_a_package_stand_above_those_they_use(drawn):
    image = drawn(**{"desk/show/view": "from onika.desk.state import model\n", "desk/state/model": ""})
    assert height(image, "desk") < height(image, "show") < height(image, "state") < height(image, "words")


def test_a_circle_is_closed_by_a_red_arrow(drawn):
    circle = {"desk/a/x": "import onika.desk.b.y\n", "desk/b/y": "import onika.desk.a.x\n"}
    assert arrows(drawn(**circle), "back") == 1


def test_the_picture_of_this_repository_overlaps_nowhere():
    picture = (ROOT / "docs" / "pictures" / "house.svg").read_text(encoding="utf-8")  # that it is of today is checked
    boxes = [
        [float(box.get(key)) for key in ("x", "y", "width", "height")]
        for box in ET.fromstring(picture).iter(f"{SVG}rect")
        if box.get("class") in ("room", "inner")
    ]
    assert len(boxes) > 20
    for number, (x, y, width, tall) in enumerate(boxes):
        for left, top, wide, high in boxes[number + 1 :]:
            is_apart = left >= x + width or x >= left + wide or top >= y + tall or y >= top + high
            is_within = x <= left and y <= top and left + wide <= x + width and top + high <= y + tall
            assert is_apart or is_within
    assert not re.search(r"-\d|nan", " ".join(re.findall(r'[xy]="[^"]*"', picture)))
