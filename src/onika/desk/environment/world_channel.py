"""The way to a runtime on which tasks take along the files of the worlds in which they have devices (decision 49)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.environment import RuntimeChannel
from onika.desk.environment.outcome.outcome import Order
from onika.store.site import Site
from onika.store.world_source import sources_of
from onika.wire import live


class WorldChannel:
    """Hands everything on to another channel. What is wrong with a world's files its runtime says of the devices."""

    def __init__(self, channel: RuntimeChannel, site: Site) -> None:
        self._channel = channel
        self._site = site

    def send(self, order: Order) -> None:
        """Ask; tasks that are to be born bring the files of their worlds."""
        asked = order.asked
        if isinstance(asked, live.Change) and asked.spawn:
            worlds, _ = sources_of(asked.spawn, self._site)
            order = replace(order, asked=structs.replace(asked, worlds=worlds)) if worlds else order
        self._channel.send(order)
