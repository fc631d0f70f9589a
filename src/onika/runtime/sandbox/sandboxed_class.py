"""The class of a task whose module is in a sandbox: made of what the module declares there, which has to be the same.

What a module declared when it was looked at was held against its `.rmod` and agreed to; in its sandbox it may lie.
"""

from collections.abc import Mapping
from typing import Any

from onika.model.port import PortKind
from onika.runtime import declaration
from onika.runtime.command import DeviceGrant, Spawn
from onika.runtime.declaration import Input, Local, PortDeclaration
from onika.runtime.error import LawBroken
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.sandbox import sandbox_messages as messages
from onika.runtime.sandbox.sandboxed_module import LOADING_S, Sandbox, SandboxedModule, message_of
from onika.words.reason import Reason

_DECLARATIONS: dict[str, type[PortDeclaration]] = {
    PortKind.INCONST.value: declaration.InConst,
    PortKind.OUTCONST.value: declaration.OutConst,
    PortKind.INVAR.value: declaration.InVar,
    PortKind.OUTVAR.value: declaration.OutVar,
    PortKind.INBOTH.value: declaration.InBoth,
    PortKind.OUTBOTH.value: declaration.OutBoth,
}


def sandboxed_class(declared: messages.Declared, sandbox: Sandbox, grant: DeviceGrant | None) -> type[SandboxedModule]:
    """The class of a task whose module is in this sandbox; raises ValueError where the declarations cannot be."""
    sheet = declared.sheet
    attributes: dict[str, Any] = {
        "__doc__": sheet.doc,
        "_sandbox": sandbox,
        "_grant": grant,
        "trigger": sheet.trigger,
        "passive": sheet.passive,
        "hardware": sheet.hardware,
        "crit": sheet.crit,
    }
    for attribute, port, step in zip(declared.attributes, sheet.ports, declared.steps, strict=True):
        attributes[_free(attribute, attributes)] = _DECLARATIONS[port.kind](
            port.shape, port.unit, port.meaning, name=port.name, step=step
        )
    for given in sheet.inputs:
        attributes[_free(given.name, attributes)] = Input(
            given.shape, given.unit, given.meaning, low=given.low, high=given.high, default=given.default
        )
    for local in sheet.locals:
        attributes[_free(local.name, attributes)] = Local(
            local.shape, local.unit, local.meaning, default=local.default, low=local.low, high=local.high
        )
    return type("SandboxedTask", (SandboxedModule,), attributes)


def load_sandboxed(spawn: Spawn, sandbox: Sandbox | None) -> type[SandboxedModule] | Reason:
    """The class of a task whose module its sandbox was told to load, or why there is none; waits for it.

    Raises LawBroken where the sandbox says nothing that can be understood, ValueError as above.
    """
    if sandbox is None:
        return Reason.of("runtime.sandbox_missing")
    answer = message_of(sandbox.answer(LOADING_S))
    match answer:
        case messages.Declared():
            if answer.sheet != spawn.sandboxed_as:
                return Reason.of("runtime.sandbox_declares")
            cls = sandboxed_class(answer, sandbox, spawn.device)
            sheet_of(cls)  # its steps stand in no sheet, and may be wrong
            return cls
        case messages.Refused():
            return answer.reason
    raise LawBroken(Reason.of("runtime.sandbox_answer", why=type(answer).__name__))


def _free(attribute: str, taken: Mapping[str, Any]) -> str:
    """A name that stands for nothing of ours; raises ValueError."""
    if attribute in taken or attribute.startswith("_") or hasattr(SandboxedModule, attribute):
        raise ValueError(Reason.of("runtime.sandbox_name", name=attribute))
    return attribute
