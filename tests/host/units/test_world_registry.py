import importlib
import sys

import pytest
from hypothesis import given, strategies as st

from kit.worlds.box_cells import boxes_files
from kit.worlds.installed_world import CELL, install_world
from onika.host.units import world_registry
from onika.host.units.world_registry import is_simulated, offered_worlds, refuse_unknown, split


def open_world(name, shake=None, **more):
    return world_registry.open_world(name, shake, boxes_files(), **more)


@pytest.fixture
def cell(tmp_path, monkeypatch):
    """Two installed worlds that do not say that nothing moves: one says the contrary, one says nothing."""
    install_world(tmp_path, "cell")
    install_world(tmp_path, "silent", CELL.replace("is_simulated = False", "is_simulated = 'no'"))
    monkeypatch.syspath_prepend(tmp_path)
    importlib.invalidate_caches()
    yield
    for name in ("cell_of_test", "silent_of_test"):
        sys.modules.pop(name, None)


def test_a_world_is_found_by_its_name():  # law 16
    world = open_world("boxes")
    assert {"arm_left", "gripper_left", "lamp"} <= {sheet.name for sheet in world.devices()}
    assert open_world("boxes") is not world


def test_a_shaken_world_has_its_things_a_little_elsewhere_the_same_for_one_seed():  # R-X07
    poses = [open_world("boxes", shake).poses() for shake in (None, 1, 1, 2)]
    assert (poses[1] == poses[2]).all()
    for pose in (poses[1], poses[3]):
        assert 1e-5 < abs(pose - poses[0]).max() <= 0.0010001
    assert abs(poses[3] - poses[1]).max() > 1e-5


@pytest.mark.usefixtures("cell")
def test_an_installed_world_that_cannot_be_shaken_is_as_it_is():  # R-X07
    assert (open_world("cell", 1).poses() == open_world("cell").poses()).all()


def test_an_installed_world_that_can_be_shaken_is(tmp_path, monkeypatch):  # R-X07
    shaken = "\n    @classmethod\n    def shaken(cls, seed):\n        cls.seed = seed\n        return cls()\n"
    install_world(tmp_path, "loose", CELL + shaken)
    monkeypatch.syspath_prepend(tmp_path)
    importlib.invalidate_caches()
    assert open_world("loose", 7).seed == 7
    sys.modules.pop("loose_of_test", None)


@pytest.mark.usefixtures("cell")
def test_an_unknown_world_names_those_there_are():  # law 16
    with pytest.raises(ValueError, match=r"expected a world \(cell, silent\), found 'atlantis'"):
        open_world("atlantis")


def test_a_world_that_lacks_something_is_refused_and_what_it_lacks_is_named(tmp_path, monkeypatch):  # law 16
    source = "class Bare:\n    step_ns = 2_000_000\n    now_ns = 0\n    is_simulated = True\n"
    install_world(tmp_path, "bare", source, "Bare")
    monkeypatch.syspath_prepend(tmp_path)
    importlib.invalidate_caches()
    with pytest.raises(ValueError, match=r"world bare: Bare lacks devices, claim, .*, lit, .*fingerprint"):
        open_world("bare")
    sys.modules.pop("bare_of_test", None)


def test_a_copy_of_a_simulated_world_is_a_world_of_its_own():  # R-E09
    here, there = open_world("boxes"), open_world("boxes@copy")
    here.claim("arm_left", 1)
    there.claim("arm_left", 2)
    assert (is_simulated("boxes", boxes_files()), is_simulated("boxes@copy", boxes_files())) == (True, True)
    for name in ("boxes@", "@copy", "atlantis@copy"):
        with pytest.raises(ValueError, match=f"found '{name}'"):
            open_world(name)


@pytest.mark.usefixtures("cell")
def test_a_world_that_does_not_say_that_it_is_simulated_is_real_and_no_copy_is_made_of_it():  # R-E09
    assert offered_worlds() == ("cell", "silent")
    for name in ("cell", "silent"):
        assert is_simulated(name) is False
        open_world(name)
        with pytest.raises(ValueError, match=f"expected a simulated world to make a copy of, found {name}, which is"):
            open_world(f"{name}@copy")


def test_whether_an_unknown_world_is_simulated_nobody_says():  # R-E09
    with pytest.raises(ValueError, match="found 'atlantis'"):
        is_simulated("atlantis")


def test_a_world_that_is_not_open_is_refused_with_those_that_are():
    refuse_unknown("sea", ("yard", "sea"))
    with pytest.raises(ValueError, match=r"expected an open world \(sea, yard\), found 'lake'"):
        refuse_unknown("lake", ("yard", "sea"))
    with pytest.raises(ValueError, match="none is open"):
        refuse_unknown("lake", ())


def test_a_device_is_a_world_and_a_name():  # law 16
    assert split("boxes:arm_left") == ("boxes", "arm_left")
    assert split("a:b:c") == ("a", "b:c")


@given(st.text(max_size=10))
def test_whatever_is_no_device_is_refused_with_what_was_expected(text):
    world, colon, name = text.partition(":")
    if world and colon and name:
        assert split(text) == (world, name)
    else:
        with pytest.raises(ValueError, match="expected WORLD:DEVICE"):
            split(text)


def test_a_world_is_opened_with_what_is_otherwise_in_it_and_so_is_a_copy():  # R-X23
    for name in ("boxes", "boxes@other"):
        plain, heavy = open_world(name), open_world(name, values={"boxes": {"mass": 4.0}, "yard": {"mass": 9.0}})
        assert heavy.fingerprint() == plain.fingerprint()
        assert sum(heavy._plant.model.body_mass) > 2.0 * sum(plain._plant.model.body_mass)


def test_a_world_of_which_nothing_can_be_varied_says_so(monkeypatch):  # R-X23
    monkeypatch.delattr("onika.workcell.driven_world.DrivenWorld.vary")
    assert open_world("boxes", values={"yard": {"mass": 2.0}})
    with pytest.raises(ValueError, match="expected a world of which something can be varied, found boxes"):
        open_world("boxes", values={"boxes": {"mass": 2.0}})
