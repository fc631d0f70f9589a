"""What whoever looks sees of worlds that other processes step: asked once, then as these say it by themselves."""

from collections.abc import Callable, Collection, Mapping

from onika.host.units import device_messages
from onika.host.units.device_servers import DeviceServers
from onika.host.units.pose_stream import WorldPoses
from onika.host.units.world_registry import split
from onika.runtime.bus import Poses
from onika.runtime.picture import SmallPicture

Ask = Callable[[str, device_messages.Order], device_messages.Word]
"""Ask the server of a world; raises ValueError where it does not answer."""


class ServedViews:
    """The views of all open worlds, by name."""

    def __init__(self, devices: DeviceServers, opened: Mapping[str, str], ask: Ask) -> None:
        self._devices = devices
        self._opened = opened
        self._ask = ask
        self._streamed: set[str] = set()
        self._poses: dict[str, Poses] = {}
        self._looked_at: set[str] = set()
        self._small: dict[str, SmallPicture] = {}

    def scene(self, world: str) -> dict[str, object] | None:
        """What an open world consists of. None where it cannot be known now."""
        if world not in self._opened or self._devices.is_lost:
            return None
        try:
            answer = self._ask(world, device_messages.DescribeWorld(world))
        except ValueError:  # something else failed meanwhile, and is told; nothing ends because of what is looked at
            return None
        if isinstance(answer, device_messages.WorldDescribed):
            return answer.scene
        return None

    def poses(self, world: str) -> Poses | None:
        """Where the bodies of an open world are, as the device server said last; from then on it says so."""
        if world in self._opened and world not in self._streamed:
            self._streamed.add(world)
            self._devices.send(world, device_messages.StreamPoses(world))
        return self._poses.get(world)

    def picture(self, device: str) -> SmallPicture | None:
        """The newest picture of a camera for whoever looks, as the device server said last; from now on it says so."""
        world, camera = split(device)
        if world in self._opened and device not in self._looked_at:
            self._looked_at.add(device)
            self._devices.send(world, device_messages.ShowCamera(world, camera, True))
        return self._small.get(device)

    def look_only_at(self, cameras: Collection[str]) -> None:
        """Nobody looks at any other camera any more."""
        for device in self._looked_at - set(cameras):
            world, camera = split(device)
            self._devices.send(world, device_messages.ShowCamera(world, camera, False))
            self._looked_at.discard(device)
            self._small.pop(device, None)

    def pose_to(self, world: str, inlet: int) -> None:
        """From now on the device server says the same at this socket too."""
        self._devices.send(world, device_messages.StreamPoses(world), (inlet,))

    def take(self, word: WorldPoses | device_messages.PictureTaken) -> None:
        """The device server says where everything is, or what a camera sees."""
        if isinstance(word, WorldPoses):
            self._poses[word.world] = (word.at_ns, word.rows, word.lit)
        else:
            self._small[f"{word.world}:{word.camera}"] = (word.number, word.taken_ns, word.file)
