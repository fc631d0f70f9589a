"""What a site says of itself to whoever comes over HTTP: its card, and a runtime that it hands over (A15, F06)."""

from msgspec import Struct

from onika.wire.booking import Booking
from onika.words.reason import NOTHING, Reason


class LaunchCard(Struct, frozen=True):
    """Something that the site may launch, and how it stands.

    state       `off`, `starting`, `running`, or `failed`, with the reason
    stays       whether it stays when nobody is connected any more
    holders     who holds what: users by subsystem
    users       who is connected
    runs        the applications that go on
    bookings    when its robot is booked, earliest first
    """

    name: str
    state: str = "off"
    reason: Reason = NOTHING
    worlds: tuple[str, ...] = ()
    robot: str = ""
    is_virtual: bool = False
    stays: bool = False
    port: int = 0
    holders: dict[str, str] = {}
    users: tuple[str, ...] = ()
    runs: tuple[str, ...] = ()
    is_stopped: bool = False
    bookings: tuple[Booking, ...] = ()


class SiteCard(Struct, frozen=True, tag_field="onika", tag="site"):
    """A site: what it is called, by what it is known again, and all that it may launch.

    identity    drawn once at random, so that two sites of one name are told apart
    now_s       what time it is there, in seconds of UTC since 1970
    you, role   as whom the site knows who asks
    """

    site: str
    identity: str
    now_s: float
    you: str
    role: str
    launches: tuple[LaunchCard, ...] = ()


class SiteHandOver(Struct, frozen=True, tag_field="onika", tag="launched"):
    """A runtime that runs now at the site, and how it is reached: at a port of the same machine,
    over TLS where the site is, with the same token.

    is_new      False: it was there already
    stays       whether it stays when nobody is connected any more
    """

    site: str
    identity: str
    name: str
    port: int
    is_new: bool
    stays: bool
