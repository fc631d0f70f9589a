"""Opens connections to a runtime that a site launches first, when somebody comes (requirement A15).

The runtime listens at a port of the site's machine, and knows the site's users: the token is the same. It is launched
once: when it is gone, that is told, and nothing is started anew by itself.
"""

import threading
from pathlib import Path

from onika.files.state.known_sites import KnownSites
from onika.link.channel import Channel
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_client import SiteClient
from onika.link.websocket import WebSocketCarrier
from onika.link.websocket_opening import WebSocketOpening
from onika.wire.site_card import LaunchCard, SiteHandOver
from onika.words.reason import Reason, reason_of


class SiteOpening:
    """The way to one runtime of a site; more than one thread may open.

    authority   a file of certificates that are trusted beside the system's
    meets       the sites that are known; None: whoever is there is believed
    """

    def __init__(
        self, address: SiteAddress, token: str, authority: Path | None = None, meets: KnownSites | None = None
    ) -> None:
        self.address = address
        self._token = token
        self._authority = authority
        self._meets = meets
        self._client = SiteClient(address, token, authority)
        self._lock = threading.Lock()
        self._opening: WebSocketOpening | None = None

    def __call__(self, channel: Channel) -> WebSocketCarrier:
        """Open a connection for a channel; raises LinkLost."""
        with self._lock:
            if self._opening is None:
                self._opening = self._launched()
            opening = self._opening
        try:
            return opening(channel)
        except LinkLost as lost:
            if lost.cause is LossCause.UNREACHABLE:
                raise self._why_gone(lost) from None
            raise

    # Inner

    def _launched(self) -> WebSocketOpening:
        if not self.address.name:
            card = self._client.card()
            names = tuple(launch.name for launch in card.launches)
            raise LinkLost(LossCause.REFUSED, Reason.of("link.site_which", site=card.site, names=names))
        hand_over = self._client.launch()
        self._judge(hand_over)
        there = self.address.runtime(hand_over.port)
        return WebSocketOpening(there, self._token, self._authority)

    def _judge(self, hand_over: SiteHandOver) -> None:
        """Whether it is the site that was known by this name."""
        if self._meets is None:
            return
        try:
            other = self._meets.meet(hand_over.site, hand_over.identity, self.address.place)
        except OSError as fault:
            raise LinkLost(LossCause.REFUSED, Reason.of("link.sites_not_kept", why=reason_of(fault))) from None
        if other is not None:
            twice = Reason.of("link.site_twice", site=hand_over.site, place=other.place, here=self.address.place)
            raise LinkLost(LossCause.FORBIDDEN, twice)

    def _why_gone(self, lost: LinkLost) -> LinkLost:
        """Where the site is there and its runtime is not, that is final."""
        try:
            launches = {launch.name: launch for launch in self._client.card().launches}
        except LinkLost:
            return lost
        launch = launches.get(self.address.name, LaunchCard(self.address.name))
        if launch.state in ("running", "starting"):
            return lost
        return LinkLost(LossCause.OVER, Reason.of("link.site_ended", address=str(self.address), why=launch.reason))
