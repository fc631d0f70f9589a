from types import SimpleNamespace

from onika.host.loading.world_kinds import driven_kinds, world_list
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason


class Loading:
    def is_simulated(self, world):
        if world == "atlantis":
            return Fault(Place(world), Reason.plain("it is sunk"), NOTHING)
        return world.startswith("boxes")


def test_worlds_are_told_real_or_simulated_and_why_others_cannot_be_used():  # R-E09
    listed = world_list(("cell", "atlantis", "boxes"), Loading())
    assert listed.simulated == {"boxes": True, "cell": False}
    assert listed.faults == {"atlantis": Reason.plain("it is sunk")}


def test_of_a_plan_those_in_which_its_tasks_have_devices():  # R-E09
    devices = ("cell:arm", "boxes@copy:arm", None, "atlantis:arm")
    assert driven_kinds([SimpleNamespace(device=device) for device in devices], Loading()) == {
        "boxes@copy": True,
        "cell": False,
    }
