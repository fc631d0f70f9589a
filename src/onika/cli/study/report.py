"""`onika study report`: from the logs of all subjects to one page and its figures (requirements H02, H03)."""

import argparse
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from onika.cli.language import say
from onika.files import whole
from onika.study import folder as study_folder
from onika.study.source_tables import FOLDER
from onika.words.fault import Refusal
from onika.words.own_language import own_language
from onika.words.reason import Reason

if TYPE_CHECKING:
    from onika.study.compared import ComparedFigure

PAGE, OUT = "report.html", "report"


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("cli.study_report")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    parser.add_argument("folder", type=Path, nargs="?", metavar="DIR", help=say(Reason.of("cli.study_folder")))
    parser.add_argument("--source", action="store_true", help=say(Reason.of("cli.study_source")))
    parser.add_argument("-o", dest="out", type=Path, metavar="OUT", help=say(Reason.of("cli.study_out")))
    parser.set_defaults(complain=parser.error)


def carry_out(given: argparse.Namespace) -> int:
    """Write the report; 1 where something could not be read, 2 where there is none."""
    if (given.folder is None) != given.source:
        given.complain(say(Reason.of("cli.study_which")))
    folder = FOLDER if given.source else given.folder
    if not folder.is_dir():
        return _failed(Reason.of("cli.study_no_folder", path=str(folder)))
    study = study_folder.read(folder)
    if not study.subjects:
        for fault in study.faults:
            print(say(fault.sentence), file=sys.stderr)
        return _failed(Reason.of("cli.study_nobody", path=str(folder)))
    try:
        from onika.study.compared import compared
    except ImportError:
        return _failed(Reason.of("cli.study_no_scipy"))
    from onika.study.report.figure_files import files
    from onika.study.report.page import page

    figures = compared(study.subjects)
    out = given.out or (Path(OUT) if given.source else folder / OUT)
    texts = {PAGE: page(study, figures, say, own_language()), **files(study, figures)}
    if refused := _written(out, texts):
        return _failed(refused)
    for fault in study.faults:
        print(say(fault.sentence), file=sys.stderr)
    if figures:
        print(say(_summary(figures[0])))
    print(say(Reason.of("cli.study_written", path=str(out / PAGE), count=len(texts) - 1)))
    return int(any(not fault.is_note for fault in study.faults))


def _written(out: Path, texts: dict[str, str]) -> Reason | None:
    """Write the files, each whole; why one could not be. Raises OSError."""
    out.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        outcome = whole.write(out / name, text.encode("utf-8", "replace").decode(), whole.ANYTHING)
        if isinstance(outcome, Refusal):
            return outcome.sentence
    return None


def _summary(figure: "ComparedFigure") -> Reason:
    """The first comparison in a line."""
    test = figure.comparison.variance
    means = tuple(
        Reason.of("cli.study_mean", group=group.name, count=len(group.values), mean=group.mean)
        for group in figure.comparison.groups
    )
    if math.isnan(test.p):
        return Reason.of("cli.study_means", figure=figure.figure, means=means)
    p = 100.0 * test.p
    return Reason.of(
        "cli.study_compared",
        figure=figure.figure,
        means=means,
        f=test.statistic,
        between=test.between,
        within=test.within,
        p=p,
    )


def _failed(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 2
