"""The situation of a plan at its first step: every task is spawned, and who works in it is ON (requirement X24)."""

from collections.abc import Mapping

from onika.engine import news as engine_news
from onika.host.foresight.outlook import Outlook
from onika.host.foresight.situation import ForeseenTask, RunFacts, SessionFacts, Situation, looked_at
from onika.host.loading.plan_preparation import Preparation
from onika.host.run.plan_engine import plan_engine
from onika.model.lifecycle import State
from onika.model.rules.order import rank
from onika.ring.drive import DriveMode
from onika.wire.request import Begin


def planned(
    prepared: Preparation, session: str, begin: Begin, units: Mapping[str, str], sessions: Mapping[str, SessionFacts]
) -> Situation:
    """What the engine makes of a plan when it is begun by this session; `units` gives the unit of each wish."""
    tasks = {}
    for flow, wired_tasks in zip(prepared.plan.flows, prepared.flows, strict=True):
        for wired in wired_tasks:
            looks_at = looked_at(prepared.code[wired.task.digest].source)
            unit = units[wired.task.rtpu]
            facts = ForeseenTask(flow.subsystem, wired, State.WAITING, unit, wired.task.frequency, looks_at)
            tasks[facts.address] = facts
    modes = {facts.device: DriveMode.HELD for facts in tasks.values() if facts.device}
    engine = plan_engine(prepared, _ranks(prepared), begin.on_error == "wait", lambda _flow, _condition: False)
    run = RunFacts(prepared.plan.application, session, begin.on_loss, prepared.plan.flows, engine)
    first = Outlook(Situation(tasks, modes, (run,), sessions=sessions))
    first.tell_engine(0, engine_news.Run(), 0.0)
    return first.reached(records=prepared.plan.application if begin.record else "")


def _ranks(prepared: Preparation) -> dict[tuple[int, str], int]:
    ranks = {}
    for number, wired_tasks in enumerate(prepared.flows):
        hardware = [wired.name for wired in wired_tasks if wired.sheet.hardware]
        for task, place in rank([wired.meeting for wired in wired_tasks], hardware).items():
            ranks[number, task] = place
    return ranks
