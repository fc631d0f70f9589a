"""What the command line says of sites: a card, line by line; what was launched; which are known."""

from collections.abc import Iterator, Mapping

from onika.files.state.known_sites import KnownSite
from onika.wire.site_card import LaunchCard, SiteCard, SiteHandOver
from onika.words.reason import Reason
from onika.words.utc import utc

_STATES = {
    "off": Reason.of("cli.site_off"),
    "starting": Reason.of("cli.site_starting"),
    "running": Reason.of("cli.site_running"),
    "failed": Reason.of("cli.site_failed"),
}


def card(card: SiteCard) -> Iterator[Reason]:
    """A site, then each thing that it may launch."""
    yield Reason.of("cli.site_card_head", site=card.site, at=utc(card.now_s), you=card.you, role=card.role)
    for launch in card.launches:
        yield from _launch(launch)


def launched(handed: SiteHandOver, address: str) -> Reason:
    """A runtime that was handed over."""
    key = "cli.site_launched" if handed.is_new else "cli.site_ran_already"
    return Reason.of(key, name=handed.name, site=handed.site, address=address)


def listed(sites: Mapping[str, KnownSite]) -> Iterator[Reason]:
    """The sites that are known."""
    for name, site in sorted(sites.items()):
        yield Reason.of("cli.site_known_line", name=name, place=site.place, identity=site.identity[:8])


def _launch(launch: LaunchCard) -> Iterator[Reason]:
    state = _STATES.get(launch.state, Reason.plain(launch.state))
    yield Reason.of("cli.site_launch_line", name=launch.name, state=state)
    if launch.reason:
        yield Reason.of("cli.site_why", why=launch.reason)
    if launch.is_stopped:
        yield Reason.of("cli.site_stopped")
    if launch.worlds:
        yield Reason.of("cli.site_worlds", worlds=launch.worlds)
    if launch.robot:
        yield Reason.of("cli.site_robot", robot=launch.robot)
    for application in launch.runs:
        yield Reason.of("cli.site_runs", application=application)
    for subsystem, user in sorted(launch.holders.items()):
        yield Reason.of("cli.site_holds", user=user, subsystem=subsystem)
    if launch.users:
        yield Reason.of("cli.site_users", users=launch.users)
    for booking in launch.bookings:
        yield Reason.of("cli.site_booked", user=booking.user, begin=utc(booking.begin_s), end=utc(booking.end_s))
