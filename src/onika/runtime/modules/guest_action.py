"""An action that a guest carries out: a program of another framework, which stands behind a flow (requirement A20)."""

from types import SimpleNamespace
from typing import Any, ClassVar

from onika.model.port import PortKind
from onika.model.signal import Signal, finish
from onika.runtime.declaration import Local, PortDeclaration
from onika.runtime.error import ModuleError
from onika.runtime.modules.module import Module
from onika.runtime.partner.answer import PartnerAnswer
from onika.runtime.partner.partner import Partner
from onika.words.reason import Reason
from onika.words.value import ValueType

_MOST_FLOWS = 1000
_OUTPUTS = (PortKind.OUTVAR, PortKind.OUTBOTH)
_INPUTS = (PortKind.INCONST, PortKind.INVAR, PortKind.INBOTH)


class GuestAction(Module):
    """Asks a guest to carry out `action`, and ends as the guest says; subclass it for each action, and add its ports.

    It is synchronous: nothing of it runs until the answer is there. The guest is told the target by the names of the
    inputs of the user, and what all input ports hold; it may answer values for the output ports. When the task goes off
    before the answer, by *Stop* or by any other cause, it hangs up, which tells the guest to end the action.
    """

    trigger = True
    action: ClassVar[str] = ""
    """Its name, as the guest knows it."""

    GUEST = Local("string", "-", "name of the guest")
    PARTNER = Local("line", "-", "where the guest listens: unix:PATH or tcp:HOST:PORT", default="")
    STARTS = Local("line", "-", "what starts the guest, if the task is to do that", default="")
    PATIENCE = Local("double", "s", "how long the action may take", default=3600.0, low=0.001, high=3600.0)

    partner: Partner

    def init(self) -> None:
        """Meet the guest where it listens, or start it."""
        self.partner = Partner(self.PARTNER, self.STARTS, self.PATIENCE)  # type: ignore[arg-type]
        self.partner.name = str(self.GUEST)

    def on(self, inputs: SimpleNamespace) -> None:
        """Keep the target."""
        self._target = {name: getattr(inputs, name) for name in self.declared_inputs}

    def cycle(self) -> Signal | None:
        """Ask for the action."""
        values = {_coded(name, port): getattr(self, name) for name, port in self._ports(_INPUTS).items()}
        self.partner.ask("do", action=self.action, target=self._target, values=values)
        return None

    def sync(self) -> Signal | None:
        """End as the guest says; raises ModuleError for an answer that makes no sense, and then writes nothing."""
        answer = self.partner.answer
        flow = answer.number("flow", 0, _MOST_FLOWS) if "flow" in answer.fields else 0.0
        loop = answer.fields.get("loop", False)
        if flow != int(flow) or not isinstance(loop, bool):
            raise ModuleError(Reason.of("runtime.guest_outcome", flow=str(flow), loop=str(loop)[:60]))
        values = self._values(answer.fields.get("values", {}))
        if "says" in answer.fields:
            self.warn(Reason.of("runtime.it_says", words=" ".join(answer.text("says").split())))
        for name, value in values.items():
            setattr(self, name, value)
        return finish(flow=int(flow), loop=loop)

    def off(self) -> None:
        """Nobody waits any more: the guest is to know."""
        if self.partner.is_awaited:
            self.partner.hang_up()

    def _ports(self, kinds: tuple[PortKind, ...]) -> dict[str, PortDeclaration]:
        return {name: port for name, port in self.declared_ports.items() if port.kind in kinds}

    def _values(self, values: Any) -> dict[str, Any]:
        """What the outputs get, by attribute; raises ModuleError for what is no output or does not fit."""
        outputs = {_coded(name, port): name for name, port in self._ports(_OUTPUTS).items()}
        unknown = sorted(set(values) - set(outputs)) if isinstance(values, dict) else [str(values)[:60]]
        if unknown:
            names = tuple(outputs) or Reason.of("runtime.nothing")
            raise ModuleError(Reason.of("runtime.guest_values", names=names, given=tuple(unknown[:5])))
        answer = PartnerAnswer(values)
        return {outputs[name]: self._value(answer, name, outputs[name]) for name in values}

    def _value(self, answer: PartnerAnswer, name: str, attribute: str) -> Any:
        shape = self.declared_ports[attribute].shape
        if shape.type.is_text or shape.type is ValueType.CHAR:
            return answer.text(name)
        counts = self.buffer(attribute).shape if shape.dims else ()
        return answer.numbers(name, counts, *shape.type.bounds)


def _coded(attribute: str, port: PortDeclaration) -> str:
    return port.name or attribute
