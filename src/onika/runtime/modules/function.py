"""A typed Python function as a module: its parameters are ports, its result is the outputs (requirement X15)."""

import copy
import dataclasses
import inspect
from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any

from onika.model.signal import Signal
from onika.runtime.declaration import InBoth, InConst, Input, InVar, Local, OutVar, PortDeclaration
from onika.runtime.error import ModuleError
from onika.runtime.modules.module import Module
from onika.words.reason import Reason

_Law = Callable[..., Any]
_NOTHING = SimpleNamespace()
_READS = (InVar, InBoth, InConst)
_CLOCKS = ("dt", "now")


def module(
    *, hz: tuple[float, float], trigger: bool = False, passive: bool = False, crit: int = 0
) -> Callable[[_Law], type[Module]]:
    """Make a module of a function; `hz` are the rates for which it is meant.

        @module(hz=(20, 1000))
        def spring(
            Q_MEZ: InVar("double[NDOF]", "rad", "measured position"),
            K: Local("double", "N m/rad", "stiffness") = 2.0,
        ) -> OutVar("double[NDOF]", "N m", "torque", name="TAU"):
            return -K * Q_MEZ

    A parameter is annotated with the port, LOCAL parameter or user input that it stands for. Beside these there may be
    `self`, the module itself, `dt` and `now` in seconds, and parameters annotated with a class: its memory, made
    without arguments whenever the task comes on. Several outputs are a tuple. The function returns the outputs; a
    Signal instead of them, or after them, is the signal; None leaves them as they were. Raises TypeError where the
    function says too little. The function itself stays there as `law`.
    """

    def make(law: _Law) -> type[Module]:
        parts = _parts(law)
        flags = {"trigger": trigger, "passive": passive, "crit": crit}
        body: dict[str, Any] = {**parts.declared, **flags, "_parts": parts, "law": staticmethod(law)}
        body |= {"__module__": law.__module__, "__doc__": _doc(law, parts, hz, flags)}
        return type(law.__name__, (_FunctionModule,), body)

    return make


@dataclasses.dataclass(frozen=True, slots=True)
class _Parts:
    """What stands for each parameter, in their order, and the outputs."""

    declared: Mapping[str, Any]
    sources: tuple[tuple[str, str], ...]
    """Where each argument comes from (attribute, input, memory, self) and its name."""
    memories: Mapping[str, type]
    outputs: tuple[str, ...]


class _FunctionModule(Module):
    """The class behind all of them."""

    _parts: _Parts
    law: _Law

    def on(self, inputs: SimpleNamespace) -> None:
        """Inputs are kept, memories are made anew."""
        self._inputs = inputs
        self._memories = {name: made() for name, made in self._parts.memories.items()}

    def take(self, old: Any) -> None:
        """Inputs and memories go on, a dataclass field by field; what is new begins as the class says."""
        inputs = getattr(old, "_inputs", _NOTHING)
        lacking = sorted(set(type(self).declared_inputs) - set(vars(inputs)))
        if lacking:
            raise ModuleError(Reason.of("runtime.not_asked_yet", names=tuple(lacking)))
        self.on(inputs)
        for name, fresh in self._memories.items():
            self._memories[name] = _carried(getattr(old, "_memories", {}).get(name), fresh)

    def cycle(self) -> Signal | None:
        """One call of the function."""
        return self._spread(type(self).law(*[self._argument(kind, name) for kind, name in self._parts.sources]))

    def sync(self) -> Signal | None:
        """The same at each event of a synchronous task."""
        return self.cycle()

    def _argument(self, kind: str, name: str) -> Any:
        if kind == "input":
            return getattr(self._inputs, name)
        if kind == "memory":
            return self._memories[name]
        return self if kind == "self" else getattr(self, name)

    def _spread(self, result: Any) -> Signal | None:
        """The result on the outputs; the signal that came with it."""
        outputs = self._parts.outputs
        if result is None or isinstance(result, Signal):
            return result
        signal = None
        if isinstance(result, tuple) and result and isinstance(result[-1], Signal):
            *rest, signal = result
            result = rest[0] if len(outputs) == 1 and len(rest) == 1 else tuple(rest)
        values = (result,) if len(outputs) == 1 else result
        if not isinstance(values, tuple) or len(values) != len(outputs):
            names = outputs or Reason.of("runtime.nothing")
            raise ModuleError(Reason.of("runtime.result_expected", names=names, value=repr(result)))
        for name, value in zip(outputs, values, strict=True):
            setattr(self, name, value)
        return signal


def _parts(law: _Law) -> _Parts:
    signature = inspect.signature(law, eval_str=True)
    declared: dict[str, Any] = {}
    sources: list[tuple[str, str]] = []
    memories: dict[str, type] = {}
    for name, parameter in signature.parameters.items():
        stands_for, has_default = parameter.annotation, parameter.default is not inspect.Parameter.empty
        if has_default and not isinstance(stands_for, Local):
            raise TypeError(Reason.of("runtime.default_of_local", name=name, value=repr(parameter.default)))
        if name == "self" or name in _CLOCKS:
            sources.append(("self" if name == "self" else "attribute", name))
        elif isinstance(stands_for, (*_READS, Local)):
            declared[name] = stands_for
            if isinstance(stands_for, Local) and has_default:
                declared[name] = _with_default(stands_for, parameter.default)
            sources.append(("attribute", name))
        elif isinstance(stands_for, Input):
            declared[name] = stands_for
            sources.append(("input", name))
        elif isinstance(stands_for, type) and stands_for is not inspect.Parameter.empty:
            memories[name] = stands_for
            sources.append(("memory", name))
        else:
            raise TypeError(Reason.of("runtime.parameter_kind", name=name, value=repr(stands_for)))
    outputs = _outputs(signature.return_annotation)
    taken = sorted(set(outputs) & (set(declared) | set(memories)))
    if taken:
        raise TypeError(Reason.of("runtime.output_no_parameter", names=tuple(taken)))
    return _Parts(declared | outputs, tuple(sources), memories, tuple(outputs))


def _outputs(returned: Any) -> dict[str, OutVar]:
    """Outputs by the attributes that hold them."""
    if returned is None or returned is inspect.Signature.empty:
        return {}
    outputs = returned if isinstance(returned, tuple) else (returned,)
    for output in outputs:
        if not isinstance(output, OutVar) or not output.name:
            raise TypeError(Reason.of("runtime.result_outvar", value=repr(output)))
    return {output.name.replace("^", "_RATE"): output for output in outputs}


def _with_default(declared: Local, default: Any) -> Local:
    changed = copy.copy(declared)
    changed.default = default
    return changed


def _carried(old: Any, fresh: Any) -> Any:
    """A memory of the former module in the form of the new one."""
    if type(old) is type(fresh):
        return old
    if dataclasses.is_dataclass(fresh):
        for field in dataclasses.fields(fresh):
            if hasattr(old, field.name):
                setattr(fresh, field.name, getattr(old, field.name))
    return fresh


def _doc(law: _Law, parts: _Parts, hz: tuple[float, float], flags: Mapping[str, Any]) -> str:
    """The function's docstring, and the tables that the docstring of a module has."""
    kind = next((name for name in ("trigger", "passive") if flags[name]), "general")
    rows = [("Kind", f"{kind}, periodic, {hz[0]:g}..{hz[1]:g} Hz")]
    for attribute, declaration in parts.declared.items():
        if isinstance(declaration, PortDeclaration):
            port = declaration.port(attribute)
            rows.append(("Ports", f"{port.kind.value:8} {port.name}  {port.shape}  {port.unit}  {port.meaning}"))
    for section, sort in (("Local", Local), ("Input", Input)):
        declarations = [
            (name, declaration) for name, declaration in parts.declared.items() if isinstance(declaration, sort)
        ]
        rows += [
            (section, f"{name}  {declaration.shape}  {declaration.unit}  {declaration.meaning}")
            for name, declaration in declarations
        ]
    if flags["trigger"]:
        rows.append(("Finish", "when the function returns `finish()`"))
    text, last = [inspect.cleandoc(law.__doc__ or law.__name__), ""], ""
    for section, row in rows:
        text.append(f"    {section if section != last else '':8} {row}")
        last = section
    return "\n".join(text)
