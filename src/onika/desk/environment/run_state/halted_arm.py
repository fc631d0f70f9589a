"""Where an arm of a run stood when its drive began to hold, and what was in its way, beside a standstill (X06)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.run_state.run import Run
from onika.model.planned import task_of
from onika.model.rules.agreement import device_of
from onika.wire import event
from onika.wire.view import StopView

_NEAR_S = 1.0
"""How far apart a standstill and the hold that comes of it are told at most."""


def claims(run: Run, device: str) -> bool:
    """Whether a flow of the run has a task for a device."""
    return any(device in _devices(run, home) for home in run.homes)


def heard(run: Run, drive: event.Drive) -> Run:
    """The run after a drive has begun to hold, or follows again; a standstill that is shown says so too."""
    others = {device: halt for device, halt in run.halts.items() if device != drive.device}
    if not (drive.stands or drive.touches):
        return replace(run, halts=others) if drive.device in run.halts else run
    run = replace(run, halts={**others, drive.device: drive})
    return run.shown(stops={key: beside(run, stop) for key, stop in run.view.stops.items()})


def beside(run: Run, stop: StopView) -> StopView:
    """A standstill with what the arms of its flow said at that time."""
    devices = _devices(run, stop.subsystem)
    halts = [
        halt
        for device, halt in run.halts.items()
        if device in devices and abs(halt.at_s - stop.at_s) <= _NEAR_S and stop.kind != "user"
    ]
    if not halts:
        return stop
    stands = tuple(halt.stands for halt in halts if halt.stands)
    touches = tuple(dict.fromkeys(text for halt in halts for text in halt.touches))
    return structs.replace(stop, stands=stands, touches=touches)


def _devices(run: Run, subsystem: str) -> set[str]:
    tasks = (task for flow in run.plan.flows if flow.subsystem == subsystem for task in flow.tasks)
    return {device for task in tasks if (device := device_of(task_of(task)))}
