import pytest

from kit.desk.site_runtimes import QuietRuntime
from onika.agent import attended_runtime as room
from onika.agent.attended_runtime import AttendedRuntime
from onika.agent.launches import Guest, SiteLaunches, SiteRefusal
from onika.link.caller import Role
from onika.link.lost import LossCause
from onika.model.launch import Launch
from onika.wire.booking import Booking
from onika.words.reason import Reason

ANN, BOB, EVE, KIM = (
    Guest(*who) for who in (("ann", Role.OPERATOR), ("bob", Role.OPERATOR), ("eve", Role.VIEWER), ("kim", Role.OWNER))
)
LAUNCHES = (Launch("arm", ("boxes",), "arm_left"), Launch("crane", robot="crane", needs_booking=True))


class Book:
    """What is booked, by robot; the time stands still."""

    def __init__(self):
        self.bookings = {}

    def now_s(self):
        return 1000.0

    def of(self, robot):
        return self.bookings.get(robot, ())


class BenchSite:
    """A site whose runtimes are quiet ones."""

    def __init__(self):
        self.book, self.runtimes, self.stays = Book(), {}, []
        self.launches = SiteLaunches("cmu", "id", LAUNCHES, self.begun, self.book)

    def begun(self, launch, stays):
        self.stays.append(stays)
        return AttendedRuntime(self.runtimes.setdefault(launch.name, QuietRuntime()).opened, stays=stays)

    def card(self, name="arm"):
        return next(launch for launch in self.launches.card(ANN).launches if launch.name == name)

    def launch(self, guest=ANN, name="arm", stays=False):
        return self.launches.launch(name, guest, stays=stays)

    def no(self, do, *given, **named):
        with pytest.raises(SiteRefusal) as refusal:
            do(*given, **named)
        return refusal.value


@pytest.fixture
def site(monkeypatch):
    monkeypatch.setattr(room, "LOOK_S", 0.01)
    bench = BenchSite()
    yield bench
    bench.launches.close()


def test_what_is_listed_is_launched_once_and_joined_by_who_comes_next(site):  # R-A15
    assert site.card().state == "off"
    first, second = site.launch(stays=True), site.launch(BOB)
    assert (first.port, first.is_new, first.stays) == (4711, True, True)
    assert (second.port, second.is_new, second.stays) == (4711, False, True)
    assert site.stays == [True] and site.card().state == "running"


def test_who_comes_while_it_ends_gets_a_new_one(site):  # R-A15
    site.launch()
    ending = site.launches._runtimes["arm"]
    ending.end(Reason.plain("nobody is there"))
    again = site.launch(BOB)
    assert again.is_new and site.stays == [False, False]
    assert ending.news.state == "over" and site.card().state == "running"


def test_who_joins_may_have_it_stay(site):  # R-A15
    assert not site.launch().stays
    assert site.launch(BOB, stays=True).stays and site.card().stays


def test_nothing_else_is_launched_and_a_viewer_launches_nothing(site):  # R-A15 R-X12
    refusal = site.no(site.launch, name="sh")
    assert refusal.status == 404 and "it launches arm, crane" in str(refusal.reason)
    assert site.no(site.launch, EVE).status == 403
    assert site.no(site.launches.end, "arm", EVE).status == 403
    assert site.runtimes == {}


def test_a_launch_that_fails_is_told_with_its_reason_and_may_be_tried_again(site):  # R-A15
    broken = site.runtimes["arm"] = QuietRuntime()
    broken.fail(LossCause.CLOSED, Reason.plain("the port is taken"))
    assert "arm is not launched: the port is taken" in str(site.no(site.launch).reason)
    assert (site.card().state, str(site.card().reason)) == ("failed", "the port is taken")
    broken.lost = None
    assert site.launch().is_new


def test_a_robot_that_is_booked_is_launched_for_whom_it_is_booked(site):  # R-F09
    site.book.bookings["arm_left"] = (Booking(1, "bob", 900, 2000),)
    assert "booked for bob" in str(site.no(site.launch).reason)
    assert site.launch(BOB).is_new
    assert not site.launch(ANN).is_new  # to look, and to stop; the runtime says what else
    assert "only for who has booked" in str(site.no(site.launch, name="crane").reason)
    assert site.card().bookings == site.book.bookings["arm_left"]


def test_who_is_there_and_holds_what_is_on_the_card(site):  # R-F06
    quiet = site.runtimes["arm"] = QuietRuntime()
    quiet.come("ann#2", "bob#3")
    quiet.hold("flow0", "ann#2", "assemble")
    site.launch()
    card = site.card()
    assert (card.users, card.holders, card.runs) == (("ann", "bob"), {"flow0": "ann"}, ("assemble",))


def test_it_is_ended_where_nobody_else_is_there_and_by_the_owner_always(site):  # R-A15
    quiet = site.runtimes["arm"] = QuietRuntime()
    assert "does not run" in str(site.no(site.launches.end, "arm", ANN).reason)
    quiet.come("ann#2", "bob#3")
    site.launch()
    assert "bob are there" in str(site.no(site.launches.end, "arm", ANN).reason)
    site.launches.end("arm", KIM)
    assert site.card().state == "off" and "kim has ended it" in str(site.card().reason)
    assert site.card().users == ()
    quiet.come("ann#2")
    site.launch()
    site.launches.end("arm", ANN)
    assert not quiet.is_open


def test_with_the_site_everything_ends_and_nothing_begins_any_more(site):  # R-A15
    site.launch()
    site.launches.close()
    assert not site.runtimes["arm"].is_open
    assert site.no(site.launch).status == 503
