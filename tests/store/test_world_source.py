"""Worlds gathered from the search path."""

import pytest

from kit.worlds.file_cells import CELL
from onika.store.site import open_site
from onika.store.world_source import gather_world, world_path


@pytest.fixture
def lab(tmp_path):
    for name, text in CELL.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.fixture
def site(lab):
    return open_site([lab], {}, None)


def test_a_world_comes_with_its_robots_and_their_models(site):  # R-X19
    source, faults = gather_world("cell", site)
    assert faults == ()
    assert {file.name for file in source.files} == set(CELL)
    assert gather_world("cell@copy", site)[0].digest == source.digest


def test_what_is_nowhere_is_no_world(site):
    assert gather_world("other", site) == (None, ())
    assert world_path("../cell", site) is None


def test_a_broken_world_is_told_with_its_line(lab, site):  # R-B07
    (lab / "world" / "cell.world").write_text(CELL["world/cell.world"].replace("FLOOR 0", "FLOOR low"))
    source, faults = gather_world("cell", site)
    assert source is None
    assert [(fault.place.file, fault.place.line) for fault in faults] == [(str(lab / "world" / "cell.world"), 3)]


def test_a_model_that_is_gone_is_told_where_it_is_named(lab, site):  # R-B07
    (lab / "robot" / "elbow.xml").unlink()
    source, faults = gather_world("cell", site)
    assert source is not None
    assert [(fault.place.line, fault.reason.key) for fault in faults] == [(2, "store.model_nowhere")] * 2
