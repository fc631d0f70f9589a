"""The frequency response of two variables of a recording, as lines of text or as a table for other programs."""

import argparse
import csv
from math import isnan
from pathlib import Path

import numpy as np

from onika.cli.language import say
from onika.desk.run.run_review import Review
from onika.desk.run.text_table import Cell, lines
from onika.record.downsampled import is_drawn, samples
from onika.record.even_samples import ElementCourse, EvenSamples, even_samples
from onika.record.frequency_response import RELIABLE, FrequencyResponse, frequency_response
from onika.record.reader import complaint
from onika.record.response_readings import readings
from onika.record.stored import unfit
from onika.words.reason import Reason, reason_of

_PER_DECADE = 10


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("file", type=Path, metavar="RUN.mcap")
    for option, dest, help_key in (
        ("--from", "reference", "cli.response_reference"),
        ("--to", "measured", "cli.response_measured"),
    ):
        parser.add_argument(option, dest=dest, required=True, metavar="NAME", help=say(Reason.of(help_key)))
    for option, metavar, help_key in (
        ("--begin", "S", "cli.response_begin"),
        ("--end", "S", "cli.response_end"),
        ("--segment", "S", "cli.response_segment"),
        ("--rate", "HZ", "cli.response_rate"),
    ):
        parser.add_argument(option, type=_positive, metavar=metavar, help=say(Reason.of(help_key)))
    parser.add_argument("--open-loop", action="store_true", help=say(Reason.of("cli.response_open")))
    parser.add_argument("--output", type=Path, metavar="FILE.csv", help=say(Reason.of("cli.response_output")))


def write(review: Review, given: argparse.Namespace) -> None:
    """Print it, or write every frequency of it to a file; raises ValueError where there is none."""
    begin_ns = round((given.begin or 0.0) * 1e9)
    end_s = review.span_s[1] if given.end is None else min(given.end, review.span_s[1])
    end_ns = round(end_s * 1e9)
    reference, measured = (_course(review, name, begin_ns, end_ns) for name in (given.reference, given.measured))
    try:
        pair = even_samples(reference, measured, begin_ns, end_ns, given.rate)
        response = frequency_response(pair.reference, pair.measured, pair.step_s, _segment(given.segment, pair.step_s))
    except ValueError as wrong:
        raise unfit(review.path, reason_of(wrong)) from None
    print(say(_head(reference.name, measured.name, pair, response.segments)))
    for line in _readings(response, given.open_loop):
        print(say(line))
    if given.output is None:
        titles = (Reason.of("cli.response_gain"), Reason.of("cli.response_phase"), Reason.of("cli.response_coherence"))
        print("\n".join(lines(("Hz", *titles), _rows(response), say)))
        return
    _save(response, given.output)
    print(say(Reason.of("cli.response_written", rows=len(response.hertz), path=str(given.output))))


def _course(review: Review, wanted: str, begin_ns: int, end_ns: int) -> ElementCourse:
    """The element of a variable that was named; the value before the beginning comes with it."""
    drawn = {name: series for name, series in review.series.items() if is_drawn(series)}
    elements = {
        f"{series.subsystem}/{label}": (series, place)
        for series in drawn.values()
        for place, label in enumerate(series.labels)
    }
    meant = [wanted] if wanted in elements else [name for name in elements if name.partition("/")[2] == wanted]
    if len(meant) != 1:
        of_variable = [name for name in elements if wanted in (name.partition("[")[0], _bare(name))]
        choices = tuple(meant or of_variable or drawn)
        raise unfit(review.path, Reason.of("cli.no_element", names=choices, name=wanted))
    series, place = elements[meant[0]]
    course = samples(series, begin_ns, end_ns)
    return ElementCourse(meant[0], course.at_ns, course.values[:, place])


def _bare(element: str) -> str:
    """NAME of SUBSYSTEM/NAME[0]."""
    return element.partition("/")[2].partition("[")[0]


def _head(reference: str, measured: str, pair: EvenSamples, segments: int) -> Reason:
    samples, rate = len(pair.measured), 1.0 / pair.step_s
    if segments == 0:
        return Reason.of("cli.response_of_step", reference=reference, measured=measured, samples=samples, rate=rate)
    return Reason.of(
        "cli.response_of_course",
        reference=reference,
        measured=measured,
        segments=segments,
        samples=samples,
        rate=rate,
    )


def _segment(seconds: float | None, step_s: float) -> int:
    """The number of samples: a power of two, near what was said; 0: nothing was said."""
    return 0 if seconds is None else 1 << max(round(np.log2(max(seconds / step_s, 1.0))), 0)


def _readings(response: FrequencyResponse, is_open: bool) -> list[Reason]:
    if not response.is_reliable.any():
        return [Reason.of("cli.response_unreliable", least=RELIABLE)]
    reading = readings(response, is_open)
    highest = float(response.hertz[response.is_reliable][-1])
    sentences = [
        Reason.of("cli.response_no_bandwidth", hertz=highest, low=reading.low_db)
        if isnan(reading.bandwidth_hz)
        else Reason.of("cli.response_bandwidth", hertz=reading.bandwidth_hz, low=reading.low_db)
    ]
    if reading.peak_db > 0.0:
        sentences.append(Reason.of("cli.response_peak", peak=reading.peak_db, hertz=reading.peak_hz))
    if isnan(reading.phase_margin):
        sentences.append(Reason.of("cli.response_no_phase_margin"))
    else:
        at = {"degrees": reading.phase_margin, "hertz": reading.phase_margin_hz}
        sentences.append(Reason.of("cli.response_phase_margin", **at))
    if isnan(reading.gain_margin_db):
        sentences.append(Reason.of("cli.response_no_gain_margin"))
    else:
        at = {"decibels": reading.gain_margin_db, "hertz": reading.gain_margin_hz}
        sentences.append(Reason.of("cli.response_gain_margin", **at))
    return sentences


def _rows(response: FrequencyResponse) -> list[list[Cell]]:
    """Some frequencies of each decade, evenly on a logarithmic axis."""
    decades = np.floor(np.log10(response.hertz) * _PER_DECADE + 0.5)
    places = np.flatnonzero(np.diff(decades, prepend=-np.inf))
    columns = (response.hertz, response.decibels, response.degrees, response.coherence)
    return [
        [f"{hertz:.4g}", f"{decibels:.2f}", f"{degrees:.1f}", "-" if isnan(coherence) else f"{coherence:.3f}"]
        for hertz, decibels, degrees, coherence in zip(*(column[places].tolist() for column in columns), strict=True)
    ]


def _save(response: FrequencyResponse, path: Path) -> None:
    try:
        stream = path.open("w", newline="", encoding="utf-8")
    except OSError as wrong:
        raise ValueError(complaint(path, wrong)) from None
    with stream:
        table = csv.writer(stream)
        table.writerow(["frequency_Hz", "gain_dB", "phase_deg", "coherence"])
        columns = (response.hertz, response.decibels, response.degrees, response.coherence)
        for row in zip(*(column.tolist() for column in columns), strict=True):
            table.writerow(["" if isnan(value) else value for value in row])


def _positive(text: str) -> float:
    try:
        amount = float(text)
    except ValueError:
        amount = -1.0
    if not 0.0 < amount <= 1e9:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.amount_expected", text=text)))
    return amount
