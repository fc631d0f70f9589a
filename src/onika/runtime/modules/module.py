"""The module: a plain class with typed port declarations and a fixed set of entry points (dissertation §3.2.1)."""

import random
from collections.abc import Mapping, Sequence
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, ClassVar

from onika.model.port import PortKind
from onika.model.signal import Signal
from onika.runtime.declaration import Input, Local, PortDeclaration, slot
from onika.runtime.device import Device
from onika.runtime.error import ModuleError
from onika.words.module_sentence import Sentence, of_sentence
from onika.words.reason import Reason

Identity = Mapping[str, tuple[float, ...] | str]
"""What a device says of itself."""

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from onika.runtime.partner.partner import Partner


class Module:
    """Subclass this, declare ports, inputs and parameters as class attributes, and fill in entry points.

    Every entry point may be left out. None of them may wait: what must wait or compute for long gets an RTPU of its
    own. `dt` is the period in seconds, `now` the time of this cycle in seconds since the subsystem's start; take time
    from nowhere else. `random` is seeded by the run and the task. `device` is there where LOCAL has a DEVICE line.
    `partner` is an outside program that the module talks with, where its `init` makes one.
    """

    trigger: ClassVar[bool] = False
    """Ends a job by returning `finish()`."""
    passive: ClassVar[bool] = False
    """May fall silent without harm to the job."""
    hardware: ClassVar[bool] = False
    """Drives a device: source of the data flow, holds until all its inputs are fresh."""
    crit: ClassVar[int] = 0
    """Criticality: among tasks with the same deadline the higher one runs first."""

    declared_ports: ClassVar[dict[str, PortDeclaration]] = {}
    declared_inputs: ClassVar[dict[str, Input]] = {}
    declared_locals: ClassVar[dict[str, Local]] = {}

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        cls.declared_ports = dict(cls.declared_ports)
        cls.declared_inputs = dict(cls.declared_inputs)
        cls.declared_locals = dict(cls.declared_locals)
        for attribute, declared in list(vars(cls).items()):
            if isinstance(declared, PortDeclaration):
                cls.declared_ports[attribute] = declared
                setattr(cls, attribute, declared.accessor(attribute))
            elif isinstance(declared, Input):
                cls.declared_inputs[attribute] = declared
                delattr(cls, attribute)
            elif isinstance(declared, Local):
                cls.declared_locals[attribute] = declared

    def __init__(self) -> None:
        self.dt = 0.0
        self.now = 0.0
        self.random = random.Random(0)  # noqa: S311 - noise for simulation, no secret
        self.device: Device = Device.absent()
        self.partner: Partner | None = None
        self.warnings: list[Reason] = []
        self.in_force: frozenset[str] = frozenset()

    # What a module may call

    def warn(self, sentence: Sentence, /, **arguments: object) -> None:
        """Send a WARNING; nothing else happens. With arguments the sentence has gaps for them, as in `{limit:.2f}`."""
        self.warnings.append(of_sentence(sentence, arguments))

    def continues(self, name: str) -> bool:
        """During `on`: whether the variable's present value still steers something, so that it must not jump.

        It was written since the last hold of the hardware, and a task that stays ON has been reading it. A motion then
        starts from it (the port is preloaded with it), else from the measurement (law 3, reading 45).
        """
        return name in self.in_force

    def buffer(self, name: str) -> "NDArray[Any]":
        """The array behind a port, by its attribute's name; a scalar is one of a single element.

        For compiled code that works on memory: the same array until the ports are bound anew, after which `reinit` is
        called. That of an input may not be written. Raises AttributeError for what is no port.
        """
        if name not in self.declared_ports:
            ports = tuple(self.declared_ports) or Reason.of("runtime.there_is_none")
            raise AttributeError(Reason.of("runtime.port_expected", ports=ports, name=name))
        array: NDArray[Any] = getattr(self, slot(name))
        return array

    def check_drive(self) -> None:
        """After a `read` of the device: raises ModuleError while its drive has tripped or its button is pressed."""
        if not self.device.is_held:
            return  # as nearly always: one look is enough
        if self.device.is_pressed:
            raise ModuleError(Reason.of("runtime.button_pressed"))
        if self.device.is_tripped:
            raise ModuleError(Reason.of("runtime.drive_tripped"))

    def clear_drive(self) -> None:
        """In `clear`: a tripped drive comes back to hold. Raises ModuleError while its panic button is pressed."""
        self.device.read()
        if self.device.is_pressed:
            raise ModuleError(Reason.of("runtime.button_still_pressed"))
        self.device.clear()

    def state_constants(self) -> dict[str, Any]:
        """In `init` of a robot module: its OUTCONSTs take what `constants` says of them; all that it says."""
        local = SimpleNamespace(**{name: getattr(self, name) for name in self.declared_locals})
        constants = self.constants(local, getattr(self.device, "identity", {}))
        for attribute, declared in self.declared_ports.items():
            if declared.kind is PortKind.OUTCONST:
                setattr(self, attribute, constants[declared.name or attribute])
        return constants

    # Entry points

    def init(self) -> None:
        """After the constants are read: allocate, check, compute OUTCONSTs."""

    def reinit(self) -> None:
        """A constant has changed: as `init` unless said otherwise."""
        self.init()

    def on(self, inputs: SimpleNamespace) -> None:
        """All inputs are read, own outputs are preloaded with the table's values; `inputs` holds the user's input."""

    def take(self, old: Any) -> None:
        """In place of `on`, where this module is exchanged for the code of a task that is ON: go on where `old` stands.

        `old` is the instance that worked until now, to be read and not to be changed. All inputs are read and own
        outputs preloaded. What raises leaves the old one at work. Without a `take` of its own the module comes on anew.
        """

    def cycle(self) -> Signal | None:
        """One period of a periodic task, or the one run of an aperiodic one; of a synchronous one with a partner: ask.

        Anything that can be called without arguments may stand here, on the class or set by `init`: a compiled
        function, a `partial`, a C function. What it returns is a signal, None or the number 0 (nothing happened).
        """

    def sync(self) -> Signal | None:
        """A synchronous task's event has arrived; where it has a partner: the answer has."""

    def fileno(self) -> int:
        """Of a synchronous module: the file descriptor whose input is its event; asked once it is on. Never -1."""
        if self.partner is not None:
            return self.partner.fileno()
        raise ModuleError(Reason.of("runtime.no_descriptor"))

    def off(self) -> None:
        """The task goes off; outputs are not published any more."""

    def kill(self) -> None:
        """The task ends: give back what `init` took."""

    def error(self, fault: BaseException) -> bool:
        """Something raised in this module. True: mended, go on and tell nobody. False: give up (state ERROR)."""
        return False

    def clear(self) -> None:
        """The user wants this task out of ERROR; raise ModuleError if the cause is still there."""

    def get(self, name: str) -> Any:
        """The present value of something that `status` does not show."""
        raise ModuleError(Reason.of("runtime.nothing_to_get", name=name))

    def set(self, name: str, value: str) -> None:
        """Change something while the task lives."""
        raise ModuleError(Reason.of("runtime.nothing_to_set", name=name))

    def hold(self) -> None:
        """A hardware task whose inputs are not all fresh yet: called in place of `cycle`; read, command nothing."""
        self.cycle()

    def held(self, name: str) -> Any:
        """Of a hardware module: what this input would have to be for the device to stay as it is held now.

        Asked before the device follows its inputs again, so that these do not jump (law 33). None: nobody knows.
        """
        return None

    @classmethod
    def constants(cls, local: SimpleNamespace, identity: Identity) -> dict[str, Any]:
        """Of a robot module: its OUTCONSTs from its parameters and from what its device says of itself.

        Asked before anything lives, so that reach is known before a run (law 26, decision 5). `identity` is empty where
        there is no such device.
        """
        return {}

    @classmethod
    def resolve(cls, constants: dict[str, Any], targets: list[Any]) -> Sequence[Sentence | None]:
        """Of a robot module: for each target (its type in lower case and its values) why it is out of reach, or None.

        A target of a type the robot knows nothing of is none of its business: None.
        """
        return [None for _ in targets]

    @classmethod
    def poses(cls, constants: dict[str, Any], targets: list[Any]) -> list[Any] | None:
        """Of a robot module: the Cartesian targets that joint targets are, so that another robot can take them.

        Of each target the first NDOF values count. None: this robot knows of no poses.
        """
        return None

    @classmethod
    def postures(cls, constants: dict[str, Any], poses: list[Any]) -> list[Any] | None:
        """Of a robot module: joint values for Cartesian targets, each nearest to those before it, or a reason why not.

        None: this robot knows of no poses.
        """
        return None

    @classmethod
    def fits(cls, constants: dict[str, Any], local_values: dict[str, Any]) -> Sentence | None:
        """Of a hardware module: why the device that says this of itself is not the one meant; None: nothing is wrong.

        Asked before a run, so that it is told before anything moves; `init` has the last word.
        """
        return None
