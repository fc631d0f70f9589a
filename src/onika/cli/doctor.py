"""`onika doctor`: say what this machine offers and what that costs."""

import argparse
import sys
from collections.abc import Iterable

from rich.console import Console
from rich.text import Text

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.plan.lone_job import lone_job
from onika.desk.run.machine import features
from onika.store.site import Site
from onika.words.fault import Fault
from onika.words.reason import Reason

_COLUMN = 14
"""Columns for the name of a thing."""


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_doctor")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("--sweep", metavar="JOB", help=say(Reason.of("cli.doctor_sweep")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Look and say; 0 if everything is there, 1 if something is missing. The sweep of a job: 2 if there is none."""
    if given.sweep is not None:
        return _sweep(given.sweep, site_here(given.local))
    console, missing = Console(highlight=False), 0
    for offer in features():
        missing += not offer.is_there
        mark = (
            _mark(Reason.of("cli.doctor_ok"), "green") if offer.is_there else _mark(Reason.of("cli.doctor_no"), "red")
        )
        console.print(mark, Text(f"{say(offer.name):<{_COLUMN}}"), Text(say(offer.actual)), sep="")
        if not offer.is_there:
            cost = say(Reason.of("cli.doctor_cost", cost=offer.cost))
            console.print(Text(f"    {'':<{_COLUMN}}{cost}", style="yellow"))
    return 1 if missing else 0


def _sweep(name: str, site: Site) -> int:
    """Print by what source the tasks of a job are run in virtual time, each rate by itself."""
    from onika.host.execution.sweep_listing import sweep_listing  # within: only who looks at it needs all that
    from onika.host.loading.module_facts import ModuleFacts
    from onika.host.loading.plan_preparation import prepare

    job = lone_job(name, site)
    if isinstance(job, Fault) or job.plan is None:
        return _refused((job,) if isinstance(job, Fault) else job.faults)
    foreign = next((code.module for code in job.plan.code if code.is_sandboxed), None)
    if foreign is not None:
        print(say(Reason.of("desk.sandboxed_code", module=foreign)), file=sys.stderr)
        return 2
    preparation = prepare(job.plan, job.targets, ModuleFacts())
    if preparation.faults:
        return _refused(preparation.faults)
    flow = preparation.plan.flows[0]
    for rate, text in sweep_listing(
        flow.subsystem, preparation.flows[0], dict(flow.actions[0].rates), preparation.constants.get(0, {})
    ):
        print(f"# {rate:g} Hz\n{text}")
    return 0


def _refused(faults: Iterable[Fault]) -> int:
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    return 2


def _mark(word: Reason, style: str) -> Text:
    return Text(f"{say(word):<4}", style=style)
