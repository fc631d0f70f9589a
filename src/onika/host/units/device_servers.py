"""The device servers: a process for each world, so that no world waits for another one (law 16, requirement E09)."""

from collections import Counter, deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from onika.host.units import device_messages
from onika.host.units.supervisor import Supervised, Supervisor
from onika.ring.drive import DriveMode
from onika.words.reason import Reason

DEVICES = "device server"
_MODULE = "onika.host.units.device_server"

Modes = Mapping[str, DriveMode]


@dataclass(slots=True)
class _ModeQuestion:
    """How every drive stands: whose answers are still awaited, and what the others have answered."""

    answer: Callable[[Modes], None]
    awaited: set[str]
    modes: dict[str, DriveMode] = field(default_factory=dict)


class DeviceServers:
    """One of them starts with the runtime and takes its first world; every further world has one of its own.

    They are lost together: with one of them gone nothing is granted any more.
    """

    def __init__(self, supervisor: Supervisor) -> None:
        self._supervisor = supervisor
        self._homes: dict[str, Supervised] = {}
        self._answers: dict[str, deque[device_messages.Word]] = {}
        self._unawaited: Counter[str] = Counter()
        """By server, the answers that are still to come and that nobody waits for any more."""
        self._mode_questions: deque[_ModeQuestion] = deque()
        self._is_stopped = False
        self.is_lost = False
        """Whether one of them is gone."""
        self._first = self._launch(DEVICES, Reason.of("host.the_device_server"))

    def is_one(self, process: Supervised) -> bool:
        """Whether this process is one of them."""
        return process.name in self._answers

    def expect(self, worlds: Iterable[str]) -> None:
        """These worlds will be opened: what steps them is started, and nothing waits for that."""
        for world in worlds:
            self.of(world)

    def of(self, world: str) -> Supervised:
        """Who steps a world, or will step it once it is open."""
        if world not in self._homes:
            name, title = f"{DEVICES} of {world}", Reason.of("host.the_device_server_of", world=world)
            self._homes[world] = self._launch(name, title) if self._homes else self._first
            if self._is_stopped:
                self.send(world, device_messages.StopAll())
        return self._homes[world]

    def send(self, world: str, order: device_messages.Order, descriptors: tuple[int, ...] = ()) -> None:
        """Give the server of a world an order."""
        self.of(world).post.send(device_messages.encode(order), descriptors)

    def stop(self) -> None:
        """Every drive in hold, latched; also those of worlds that are opened from now on (law 27)."""
        self._is_stopped = True
        self._send_all(device_messages.StopAll())

    def allow_motion(self) -> None:
        """After a stop: commands are heard again; nothing moves by itself."""
        self._is_stopped = False
        self._send_all(device_messages.AllowMotion())

    def answered(self, process: Supervised, word: device_messages.Word) -> None:
        """One has answered."""
        if isinstance(word, device_messages.ModesTaken):
            self._take_modes(process, word)
        elif self._unawaited[process.name]:
            self._unawaited[process.name] -= 1
        else:
            self._answers[process.name].append(word)

    def has_answered(self, world: str) -> bool:
        """Whether the server of a world has answered what it was asked."""
        return bool(self._answers[self.of(world).name])

    def take_answer(self, world: str) -> device_messages.Word:
        """Its answer; raises IndexError where there is none."""
        return self._answers[self.of(world).name].popleft()

    def give_up(self, world: str) -> None:
        """Nobody waits any more for what the server of a world was asked last: it is no answer to the next question."""
        name = self.of(world).name
        if self._answers[name]:
            self._answers[name].clear()
        else:
            self._unawaited[name] += 1

    def ask_modes(self, answer: Callable[[Modes], None]) -> None:
        """How every drive stands; answered when all have said it, or at once with nothing where one is lost."""
        if self.is_lost:
            answer({})
            return
        self._mode_questions.append(_ModeQuestion(answer, {process.name for process in self._living()}))
        self._send_all(device_messages.TakeModes())

    def lose(self) -> None:
        """One is gone: whatever the others drive holds, and who waits for them is answered."""
        self.is_lost = True
        self.stop()
        while self._mode_questions:
            self._mode_questions.popleft().answer({})

    def _take_modes(self, process: Supervised, word: device_messages.ModesTaken) -> None:
        for question in self._mode_questions:
            if process.name in question.awaited:
                question.awaited.discard(process.name)
                question.modes.update(word.modes)
                break
        while self._mode_questions and not self._mode_questions[0].awaited:
            question = self._mode_questions.popleft()
            question.answer(question.modes)

    def _send_all(self, order: device_messages.Order) -> None:
        for process in self._living():
            process.post.send(device_messages.encode(order))

    def _living(self) -> list[Supervised]:
        processes = self._supervisor.processes
        return [processes[name] for name in self._answers if not processes[name].is_lost]

    def _launch(self, name: str, title: Reason) -> Supervised:
        self._answers[name] = deque()
        return self._supervisor.launch(name, title, _MODULE)
