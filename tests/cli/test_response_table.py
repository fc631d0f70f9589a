import csv
import math

import pytest

from kit.record.recording_builder import RecordingBuilder
from onika.cli import main

RATE = 250


def course(count):
    """A sweep from 0.5 to 12 Hz, and a lag of 2 Hz that follows it."""
    keep, lagging = math.exp(-2 * math.pi * 2.0 / RATE), 0.0
    for k in range(count):
        at_s = k / RATE
        wanted = math.sin(2 * math.pi * (0.5 * at_s + 11.5 * at_s**2 / (2 * count / RATE)))
        yield at_s, wanted, lagging
        lagging = keep * lagging + (1 - keep) * wanted


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    path = tmp_path_factory.mktemp("recording") / "sweep.mcap"
    rows = list(course(6000))
    tape = RecordingBuilder(path)
    tape.variable("Q_REF", "double[2]", *((at, [0.0, wanted]) for at, wanted, _ in rows), unit="rad")
    tape.variable("Q_MEZ", "double[2]", *((at, [1.0, lagging]) for at, _, lagging in rows), unit="rad")
    tape.variable("Q_MEZ", "double[2]", (0.0, [0.0, 0.0]), unit="rad", home="flow1")
    tape.variable("WORD", "byte[3]", (0.0, [0, 0, 0]))
    tape.end(completed="yes")
    return str(path)


def respond(*words):
    return main(["recording", "response", *words])


SWEEP = ("--from", "Q_REF[1]", "--to", "flow0/Q_MEZ[1]")


def test_a_recorded_sweep_gives_the_response_as_a_table(swept, capsys):  # R-C14, R-X05
    assert respond(swept, *SWEEP) == 0
    head, bandwidth, *rest = capsys.readouterr().out.splitlines()
    assert head.startswith("flow0/Q_REF[1] → flow0/Q_MEZ[1]: mean of ")
    assert head.endswith("6000 samples at 250 Hz")
    low = float(bandwidth.split()[-2])
    assert float(bandwidth.split()[3]) == pytest.approx(2 * math.sqrt(10 ** ((3.01 - low) / 10) - 1), rel=0.05)
    rows = [line.split() for line in rest[rest.index(next(line for line in rest if "coherence" in line)) + 1 :]]
    table = [[float(cell) for cell in row] for row in rows]
    hertz, decibels, degrees, coherence = min(table, key=lambda row: abs(row[0] - 4))
    assert decibels == pytest.approx(-10 * math.log10(1 + (hertz / 2) ** 2), abs=0.3)
    assert degrees == pytest.approx(-math.degrees(math.atan(hertz / 2)) - 180 * hertz / RATE, abs=1.5)
    assert coherence > 0.95


def test_every_frequency_is_saved(swept, tmp_path, capsys):  # R-X05
    path = tmp_path / "response.csv"
    assert respond(swept, *SWEEP, "--segment", "2", "--begin", "1", "--end", "900", "--output", str(path)) == 0
    rows = list(csv.DictReader(path.read_text().splitlines()))
    assert list(rows[0]) == ["frequency_Hz", "gain_dB", "phase_deg", "coherence"]
    assert float(rows[1]["frequency_Hz"]) - float(rows[0]["frequency_Hz"]) == pytest.approx(RATE / 512)
    assert f"{len(rows)} frequencies: {path}" in capsys.readouterr().out


def test_a_recorded_step_gives_it_too(tmp_path, capsys):  # R-C14
    tape = RecordingBuilder(tmp_path / "step.mcap")
    tape.variable("X", "double", (0.0, 0.0), (1.0, 2.0))
    keep = math.exp(-2 * math.pi * 5.0 / RATE)
    tape.variable("Y", "double", *((k / RATE, 2.0 * (1 - keep ** max(k - RATE, 0))) for k in range(4 * RATE)))
    tape.end()
    assert respond(str(tmp_path / "step.mcap"), "--from", "X", "--to", "Y", "--open-loop") == 0
    head, bandwidth, *rest = capsys.readouterr().out.splitlines()
    assert head.startswith("flow0/X → flow0/Y: from a step")
    assert float(bandwidth.split()[3]) == pytest.approx(5.0, rel=0.02)
    assert "phase margin: none, the gain of the open loop does not fall through 1" in rest
    assert rest[-1].split()[-1] == "-"


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (("--from", "Q_REF", "--to", "Q_MEZ[1]"), "flow0/Q_REF[0]"),
        (("--from", "Q_REF[1]", "--to", "Q_MEZ[1]"), "flow1/Q_MEZ[1]"),
        (("--from", "NONE", "--to", "Q_MEZ[1]"), "expected one of"),
        (("--from", "WORD[0]", "--to", "flow0/Q_MEZ[1]"), "the reference does not change"),
        (("--from", "Q_REF[0]", "--to", "flow0/Q_MEZ[1]"), "the reference does not change"),
        (("--from", "Q_REF[1]", "--to", "flow0/Q_MEZ[0]"), "the measurement does not change"),
        ((*SWEEP, "--end", "0.1"), "at least 64 samples"),
        ((*SWEEP, "--begin", "99"), "at least 64 samples"),
        ((*SWEEP, "--segment", "20"), "expected segments of"),
        ((*SWEEP, "--rate", "1e9"), "a shorter time or a lower rate"),
    ],
)
def test_what_has_no_response_is_told_with_its_file(words, complaint, swept, capsys):  # R-E01
    assert respond(swept, *words) == 2
    error = capsys.readouterr().err
    assert error.startswith(swept)
    assert complaint in error


def test_nothing_is_written_over_the_recording_or_where_nothing_can_be(swept, tmp_path, capsys):  # R-E01
    assert respond(swept, *SWEEP, "--output", swept) == 2
    assert "another file" in capsys.readouterr().err
    assert respond(swept, *SWEEP, "--output", str(tmp_path)) == 2
    assert str(tmp_path) in capsys.readouterr().err
    with pytest.raises(SystemExit):
        respond(swept, *SWEEP, "--segment", "-1")
