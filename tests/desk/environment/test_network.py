from dataclasses import replace
from datetime import UTC, datetime

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.fabric.announced_site import TODAY, AnnouncedSite
from onika.desk.environment.outcome.network_services import NetworkServices
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.fabric.phone_book import BOOK, PhoneBook
from onika.fabric.signed_card import bound
from onika.wire import act
from onika.wire.view import NetworkRuntimeView


@pytest.fixture
def cmu(tmp_path):
    site = AnnouncedSite(tmp_path, "cmu.puma")
    (tmp_path / "web").mkdir()
    (tmp_path / "web" / BOOK).write_bytes(bound([site.card()]))
    return site


@pytest.fixture
def desk(tmp_path):
    desk = EnvironmentFixture(tmp_path)
    noon = datetime.combine(TODAY, datetime.min.time(), UTC).timestamp() + 43_200
    services = NetworkServices(BackgroundWorker(desk.changes.put), PhoneBook(tmp_path / "state"))
    desk.surroundings = replace(desk.surroundings, network=services, calendar=lambda: noon)
    desk.begin(desk.environment.model)
    return desk


def value(desk, command):
    answer = desk.later(command)
    assert answer.no is None, answer.no
    return answer.value


def test_what_the_network_offers_is_shown_with_its_places_and_keys(desk, cmu, tmp_path):  # R-F06
    assert value(desk, act.LookAtNetwork()).places == ()
    value(desk, act.AddPlace(str(tmp_path / "web")))
    value(desk, act.AddPlace(str(tmp_path / "nothing")))
    seen = value(desk, act.LookAtNetwork())
    (site,) = seen.sites
    assert (site.name, site.signer, site.standing, site.description) == ("cmu.puma", cmu.signer, "new", "Our PUMA")
    assert site.runtimes == (NetworkRuntimeView("wss://robots.cmu.edu:7994", ("arm", "hand")),)
    assert site.libraries == ("https://robots.cmu.edu/puma",)
    assert [place.why is None for place in seen.places] == [True, False]
    value(desk, act.TrustSite("cmu.puma", site.signer))
    value(desk, act.DropPlace(str(tmp_path / "nothing")))
    seen = value(desk, act.LookAtNetwork())
    assert [place.address for place in seen.places] == [str(tmp_path / "web")]
    assert seen.sites[0].standing == "known"


def test_what_is_refused_stands_beside_its_field(desk):  # R-F06
    assert set(desk.later(act.AddPlace("ftp://x")).no.fields) == {"place"}
    assert set(desk.later(act.TrustSite("x", "y")).no.fields) == {"signer"}


def test_a_book_that_cannot_be_read_is_told(desk, tmp_path):  # R-F06
    (tmp_path / "state" / "address-book").mkdir(parents=True)
    assert desk.later(act.LookAtNetwork()).no is not None


def test_an_environment_without_a_book_looks_for_nobody(tmp_path):  # R-F06
    desk = EnvironmentFixture(tmp_path)
    for command in (act.LookAtNetwork(), act.AddPlace("lan"), act.DropPlace("lan"), act.TrustSite("x", "y")):
        assert desk.no(command).reason.key == "desk.no_network"
