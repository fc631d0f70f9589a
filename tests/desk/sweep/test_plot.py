import xml.etree.ElementTree as ET

from onika.desk.sweep.case import Case, CaseResult
from onika.desk.sweep.plot import drawn
from onika.desk.sweep.statistics import summarise
from onika.words.reason import Reason

SVG = "{http://www.w3.org/2000/svg}"


def image(results, name="stack"):
    return ET.fromstring(drawn(name, results, summarise(results), str))


def results(count, bad=()):
    return [
        CaseResult(Case(seed, {"pd.STIFF": seed / 10}), "aborted" if seed in bad else "completed", lasted_s=2.0 + seed)
        for seed in range(count)
    ]


def of(picture, kind):
    return [element for element in picture.iter() if element.get("class") == kind]


def test_every_run_is_there_good_ones_as_dots_and_others_as_crosses():  # R-X23
    picture = image(results(20, bad=(3, 4)))
    assert len(of(picture, "good")) == 18
    assert len(of(picture, "bad")) == 2
    assert len(of(picture, "share")) == 5
    assert "stack: 18 of 20 runs are good" in [text.text for text in picture.iter(f"{SVG}text")]


def test_nothing_is_drawn_outside_the_picture():  # R-X23
    picture = image(results(20, bad=(3, 4)))
    width, height = float(picture.get("width")), float(picture.get("height"))
    for panel in picture.iter(f"{SVG}g"):
        top = float(panel.get("transform").split()[1].rstrip(")"))
        for bar in panel.iter(f"{SVG}rect"):
            x, y, wide, tall = (float(bar.get(key)) for key in ("x", "y", "width", "height"))
            assert x >= 0
            assert x + wide <= width
            assert top + y >= 0
            assert top + y + tall <= height
            assert tall >= 0


def test_where_nothing_was_varied_or_nothing_is_good_the_rest_is_drawn():  # R-X23
    plain = [CaseResult(Case(seed), "completed", lasted_s=2.0 + seed) for seed in range(3)]
    assert not of(image(plain), "share")
    assert of(image(plain), "bar")
    alike = [CaseResult(Case(seed), "completed", lasted_s=2.0) for seed in range(3)]
    assert of(image(alike), "bar")
    none = [CaseResult(Case(seed, {"a.B": float(seed)}), "lost", Reason.plain("gone")) for seed in range(3)]
    assert not of(image(none), "bar")
    assert len(of(image(none), "bad")) == 3


def test_names_may_have_any_signs():  # R-X23
    assert "a<b & c: 1 of 1 runs are good" in [text.text for text in image(results(1), "a<b & c").iter(f"{SVG}text")]
