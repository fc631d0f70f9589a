"""A world that is not there is told with those of the search path (law 16)."""

from onika.desk.plan.known_worlds import file_worlds, with_worlds
from onika.store.site import open_site
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

SITE = open_site((), {}, None)


def fault(key, **args):
    return Fault(Place("lab/module/arm.rmod"), Reason.of(key, **args), Reason.of("words.nothing_run"))


def test_a_world_that_is_nowhere_is_told_with_the_worlds_of_the_search_path():  # R-E01
    none = Reason.of("host.none_installed")
    (told,) = with_worlds([fault("host.no_world_of_device", worlds=none, device="atlantis:arm")], SITE)
    assert told.reason.args["worlds"] == file_worlds(SITE) and "boxes" in told.reason.text
    assert "none installed" not in told.reason.text


def test_what_a_runtime_offers_is_named_beside_them():  # R-E01
    (told,) = with_worlds([fault("host.no_such_world", worlds=("yard",), world="atlantis")], SITE)
    assert {"yard", "boxes"} <= set(told.reason.args["worlds"])


def test_other_faults_are_as_they_were():  # R-E01
    other = fault("host.device_unlike", task="a", device="boxes:arm", why=Reason.plain("so"))
    assert with_worlds([other], SITE) == [other]
