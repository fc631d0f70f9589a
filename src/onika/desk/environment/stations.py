"""Every station of an environment has a thread of its own, so that none waits for another (requirement F02)."""

from collections.abc import Callable

from msgspec import structs

from onika.desk.environment.environment import Environment
from onika.desk.environment.outcome.outcome import Order
from onika.desk.environment.runtime_thread import Post, RuntimeOpening, RuntimeThread
from onika.desk.environment.state.model import Model
from onika.wire import page, request
from onika.words.reason import Reason


class Stations:
    """Carries each order to the runtime of its station, and brings together what is seen of all of them.

    opening     how a runtime is got hold of
    post        has something done in the environment's own thread
    clock       seconds that never go back
    """

    def __init__(self, opening: RuntimeOpening, post: Post, clock: Callable[[], float]) -> None:
        self._opening = opening
        self._post = post
        self._clock = clock
        self._threads = {"": RuntimeThread(opening, post)}
        self._environment: Environment | None = None
        self._watching: tuple[frozenset[str], frozenset[str], bool, float] = (frozenset(), frozenset(), False, 0.0)
        self._base_s = 0.0
        """The time of the first station less that of `clock`, as far as the first one has told it."""

    def begin(self, environment: Environment) -> None:
        """Work for this environment from now on."""
        self._environment = environment
        environment.followers.append(self._follow)
        for thread in self._threads.values():
            thread.begin(environment)

    def send(self, order: Order) -> None:
        """Ask the runtime of the order's station; without one the answer says so."""
        station = order.station or ""
        thread = self._thread(station)
        if thread is not None:
            thread.send(order)
        elif self._environment is not None:
            environment, refused = self._environment, request.Refused(Reason.of("run.not_linked"))
            self._post(lambda: environment.replied(order, refused))

    def watch(self, variables: frozenset[str], worlds: frozenset[str], figures: bool, hz: float) -> None:
        """What somebody wants to see from now on, whichever station has it."""
        self._watching = (variables, worlds, figures, hz)
        for thread in self._threads.values():
            thread.watch(*self._watching)

    def frame(self) -> page.Frame | None:
        """What is new of all stations since the last call; what is of others than the first one has its time too."""
        frames = {station: frame for station, thread in self._threads.items() if (frame := thread.frame()) is not None}
        if not frames:
            return None
        first = frames.get("")
        if first is not None and first.values:
            self._base_s = first.at_s - self._clock()
        if len(frames) == 1 and first is not None:
            return first
        together = page.Frame(self._base_s + self._clock())
        for frame in frames.values():
            together = structs.replace(
                together,
                values={**together.values, **frame.values},
                figures={**together.figures, **frame.figures},
                poses={**together.poses, **frame.poses},
            )
        return together

    def rest(self) -> None:
        """Nobody has to do with the first runtime now: where it is a simulator that was launched here, it may rest."""
        self._threads[""].rest()

    def wake(self) -> None:
        """Somebody has come, or does something."""
        self._threads[""].wake()

    @property
    def pid(self) -> int | None:
        """The process id of a runtime that was launched here; None: there is none."""
        return self._threads[""].pid

    def end(self) -> None:
        """End all threads, and with them a runtime that was launched here."""
        for station, thread in self._threads.items():
            if station:
                thread.let_go()
        for thread in self._threads.values():
            thread.end()

    def _thread(self, station: str) -> RuntimeThread | None:
        """The thread of a station; one that the environment does not know has none."""
        thread = self._threads.get(station)
        environment = self._environment
        if thread is None and environment is not None and station in environment.model.stations:
            thread = self._threads[station] = RuntimeThread(self._opening, self._post, station)
            thread.begin(environment)
            thread.watch(*self._watching)
        return thread

    def _follow(self, _before: Model, after: Model) -> None:
        """A station that is known no more is left."""
        for station in [name for name in self._threads if name not in after.stations]:
            self._threads.pop(station).let_go()
