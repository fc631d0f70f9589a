"""`onika sweep`: one application many times in virtual time, shaken and varied, with statistics (requirement X23)."""

import argparse
import os
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path

import msgspec

from onika.cli.argument_kinds import (
    answer_of,
    directory,
    expectation_of,
    joined_answers,
    redirect_of,
    seconds_of,
)
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.plan.preparation import PreparedRun, prepare_run
from onika.desk.plan.varied import varied
from onika.desk.run.settings import RunSettings
from onika.desk.sweep import plot
from onika.desk.sweep.case import CaseResult
from onika.desk.sweep.cluster import NoCluster, cluster_sweep
from onika.desk.sweep.design import SweepDesign
from onika.desk.sweep.results_file import ResultsFile, SweepHead, open_results
from onika.desk.sweep.statistics import SweepSummary, VariedPart, rate, summarise
from onika.desk.sweep.sweep import sweep
from onika.desk.sweep.swept_program import SweptProgram
from onika.desk.sweep.variation import Variation
from onika.desk.trial.account import digest_of
from onika.process.orderly_exit import in_order
from onika.store.site import Site
from onika.words.fault import Fault
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason_with_place

_ENDING = ".sweep"
_MOST_SEEDS = 10_000_000


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_sweep")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("application", metavar="NAME|FILE", help=say(Reason.of("cli.run_application")))
    parser.add_argument(
        "--seeds", type=_seeds, default=range(100), metavar="N|A..B", help=say(Reason.of("cli.sweep_seeds"))
    )
    parser.add_argument(
        "--vary", action="append", default=[], type=_variation, metavar="TASK.NAME=A..B",
        help=say(Reason.of("cli.sweep_vary")),
    )  # fmt: skip
    parser.add_argument(
        "--expect", action="append", default=[], type=expectation_of, metavar="'LAMP == 1'",
        help=say(Reason.of("cli.run_expect")),
    )  # fmt: skip
    parser.add_argument("--settle", type=seconds_of, default=0.5, metavar="S", help=say(Reason.of("cli.run_settle")))
    parser.add_argument("--no-shake", action="store_true", help=say(Reason.of("cli.sweep_no_shake")))
    parser.add_argument(
        "--answer", action="append", default=[], type=answer_of, metavar="TASK.NAME=VALUES",
        help=say(Reason.of("cli.run_answer")),
    )  # fmt: skip
    parser.add_argument(
        "--redirect", action="append", default=[], type=redirect_of, metavar="[FLOW:]OLD=NEW",
        help=say(Reason.of("cli.run_redirect")),
    )  # fmt: skip
    parser.add_argument("--jobs", type=_jobs, default=0, metavar="N", help=say(Reason.of("cli.test_jobs")))
    parser.add_argument("--cluster", metavar="tcp://HOST:PORT", help=say(Reason.of("cli.sweep_cluster")))
    parser.add_argument("--out", type=Path, metavar=f"OUT{_ENDING}", help=say(Reason.of("cli.sweep_out")))
    parser.add_argument("--plot", type=Path, metavar="OUT.svg", help=say(Reason.of("cli.sweep_plot")))
    parser.add_argument("--json", action="store_true", help=say(Reason.of("cli.sweep_json")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Do it; 0 if all runs are good, 1 if one is not, 2 if nothing was run."""
    design, site = _design(given), site_here(given.local)
    prepared = prepare_run(design.settings.name, site, design.settings.redirects)
    head, faults = _head(design, prepared)
    results = open_results(given.out or Path(Path(given.application).stem + _ENDING), head) if not faults else faults[0]
    if isinstance(results, Fault):
        for fault in faults or (results,):
            print(say(fault.sentence), file=sys.stderr)
        return 2
    try:
        is_whole = _run(design, prepared, site, results, given)
    except NoCluster as none:
        print(say(reason_of(none)), file=sys.stderr)
        return 2
    finally:
        results.close()
    wanted = [results.results[seed] for seed in design.seeds if seed in results.results]
    summary = summarise(wanted)
    if not given.json:
        for line in _lines(design, summary, results.path, len(design.seeds)):
            print(say(line))
    if given.plot is not None:
        _plot(given.plot, design, wanted, summary)
    if not is_whole:
        return 130
    return 0 if summary.rate.good == summary.rate.count else 1


def _design(given: argparse.Namespace) -> SweepDesign:
    settings = RunSettings(
        name=given.application,
        is_virtual=True,
        has_black_box=False,
        expectations=tuple(given.expect),
        settle_s=given.settle,
        answers=joined_answers(given.answer),
        redirects=tuple(given.redirect),
    )
    return SweepDesign(settings, given.seeds, tuple(given.vary), not given.no_shake)


def _head(design: SweepDesign, prepared: PreparedRun) -> tuple[SweepHead, tuple[Fault, ...]]:
    """What all runs have in common; why none can be run."""
    if prepared.plan is None or prepared.faults:
        return SweepHead(1, design.command, ""), prepared.faults
    first = next(design.cases())
    _, _, faults = varied(prepared.plan, first.values.items())
    return SweepHead(1, design.command, digest_of(prepared.plan)), faults


def _run(
    design: SweepDesign, prepared: PreparedRun, site: Site, results: ResultsFile, given: argparse.Namespace
) -> bool:
    """Do what is not done yet; whether all is done then. Raises NoCluster."""
    cases = [case for case in design.cases() if case.seed not in results.results]
    if given.cluster is None:
        ending = sweep(design, prepared, cases, site, given.jobs or os.cpu_count() or 1)
    else:
        ending = cluster_sweep(SweptProgram.of(design, prepared), cases, given.cluster, given.jobs)
    count, is_terminal = len(design.seeds), sys.stderr.isatty()
    try:
        with in_order():
            for result in ending:
                results.add(result)
                if given.json:
                    sys.stdout.write(msgspec.json.encode(result).decode() + "\n")
                    sys.stdout.flush()
                elif is_terminal:
                    share = rate(list(results.results.values())).share
                    line = Reason.of("sweep.progress", done=len(results.results), count=count, percent=100 * share)
                    sys.stderr.write(f"\r\x1b[K{say(line)}")
                    sys.stderr.flush()
    except KeyboardInterrupt:
        return False
    finally:
        if is_terminal and not given.json:
            sys.stderr.write("\r\x1b[K")
    return True


def _lines(design: SweepDesign, summary: SweepSummary, path: Path, count: int) -> Iterator[Reason]:
    """The summary in lines."""
    name, all_runs = Path(design.settings.name).stem, summary.rate
    least, most = all_runs.interval
    yield Reason.of(
        "sweep.good", name=name, count=all_runs.count, good=all_runs.good,
        percent=100 * all_runs.share, least=100 * least, most=100 * most,
    )  # fmt: skip
    if all_runs.count < count:
        yield Reason.of("sweep.broken_off", left=count - all_runs.count, count=count)
    if summary.lasted_s is not None:
        shortest, middle, longest = summary.lasted_s
        yield Reason.of("sweep.lasted", least=shortest, most=longest, median=middle)
    for variation, parts in summary.parts.items():
        yield Reason.of("sweep.by_value", name=variation)
        yield from (_part(part) for part in parts if part.rate.count)
    if summary.failures:
        yield Reason.of("sweep.failed_first")
        for failure in summary.failures[:10]:
            yield Reason.of("sweep.failure", count=failure.count, reason=failure.reason, seed=failure.seed)
        yield Reason.of("sweep.again", command=_again(design, summary.failures[0].seed))
    yield Reason.of("sweep.kept_in", path=str(path))


def _part(part: VariedPart) -> Reason:
    """Its numbers stand below each other."""
    percent, count = 100 * part.rate.share, part.rate.count
    if part.least == part.most:
        return Reason.of("sweep.value", least=part.least, percent=percent, count=count)
    return Reason.of("sweep.part", least=part.least, most=part.most, percent=percent, count=count)


def _again(design: SweepDesign, seed: int) -> str:
    """The command that does the run of a seed once more, bit for bit, and records it."""
    case = next(case for case in design.cases() if case.seed == seed)
    settings = design.settings
    words = ["onika", "run", settings.name, "--virtual", "--seed", str(seed)]
    words += ["--shake", str(seed)] if design.is_shaken else []
    words += [word for name, value in case.values.items() for word in ("--vary", f"{name}={value!r}")]
    words += [word for redirect in settings.redirects for word in ("--redirect", str(redirect))]
    words += [word for task, name, values in settings.answers for word in ("--answer", f"{task}.{name}={values}")]
    words += [word for condition in settings.expectations for word in ("--expect", condition.text)]
    return shlex.join([*words, "--record", f"{seed}.mcap"])


def _plot(path: Path, design: SweepDesign, wanted: list[CaseResult], summary: SweepSummary) -> None:
    try:
        path.write_text(plot.drawn(Path(design.settings.name).stem, wanted, summary, say), encoding="utf-8")
    except OSError as wrong:
        print(say(system_reason_with_place(wrong)), file=sys.stderr)
    else:
        print(say(Reason.of("sweep.plot_in", path=str(path))), file=sys.stderr)


def _seeds(text: str) -> range:
    first, dots, last = text.partition("..")
    words = (first, last) if dots else ("0", first)
    if all(word.isdigit() and word.isascii() and len(word) < 19 for word in words):
        low, high = map(int, words)
        seeds = range(low, high + 1) if dots else range(high)
        if 0 < len(seeds) <= _MOST_SEEDS:
            return seeds
    raise argparse.ArgumentTypeError(say(Reason.of("sweep.seeds", text=text)))


def _variation(text: str) -> Variation:
    try:
        return Variation.parse(text)
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def _jobs(text: str) -> int:
    if not (text.isdigit() and text.isascii() and 0 < len(text) < 4):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.whole_expected", digits=3, text=text)))
    return int(text)
