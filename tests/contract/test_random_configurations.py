"""Jobs that are put together at random on several arms: nothing breaks, or it is said in words what cannot be (K05)."""

import json
import math
from itertools import pairwise

import pytest

from kit.labs.composed_job import Composer
from kit.labs.random_arm import NAME, random_arm
from onika.cli import main
from onika.laws import adept_one, puma560
from onika.record.reader import Reader
from onika.record.series import Series
from onika.store.site import open_site

JOINTED = [(-2.9, 2.9), (-1.9, 1.9), (-2.4, 2.4), (-2.9, 2.9), (-2.0, 2.0), (-2.9, 2.9)]
PUMA = list(zip(puma560.QMIN, puma560.QMAX, strict=True))
SCARA = list(zip(adept_one.QMIN, adept_one.QMAX, strict=True))
ARMS = {
    "arm_pos": JOINTED,
    "arm_vel": JOINTED,
    "arm_tau": JOINTED,
    "arm_sim": JOINTED,
    "puma": PUMA,
    "puma_kin": PUMA,
    "scara": SCARA,
    "scara_kin": SCARA,
}
"""Hardware tasks, and the limits of their joints."""
SOFT = 0.15
"""How far physics lets a joint beyond its limit, whose end stop is soft, in rad or m."""
STEP_S = 0.002
"""Between two values of what hardware measures."""
STOP_S = 0.02
"""The time constant of a stop, damped critically: what hits it at a speed goes on by that speed times this / e."""
MEASURED = ("Q_MEZ", "Q_TRUE", "TAU_MEZ", "Q^_MEZ")
OWN = ("ModuleError", "LawBroken")
"""What a module and the executive say in words; any other exception would be a fault of the code."""
FEW, MANY = range(0, 8, 2), range(100)


def tried(seed, path, capsys):
    """Put one together, carry it out, and look at all that is left."""
    names = sorted(ARMS)
    arm = names[seed % len(names)]
    return carried_out(seed, path, capsys, arm, ARMS[arm])


def carried_out(seed, path, capsys, arm, limits):
    """The same for this hardware task, which is shipped or stands at the path."""
    site = open_site((path,), {}, None)
    composed = Composer(site, site.syntax()[0], seed).job(path, arm, limits)
    record = path / "run.mcap"
    options = ["--virtual", "--json", "--no-black-box", "--record", str(record), "--script", str(composed.script)]
    code = main(
        ["run", str(composed.program), "--local", str(path), "--on-error", "abort", "--seed", str(seed), *options]
    )
    out, err = capsys.readouterr()
    about = f"{seed}: {' '.join(composed.tasks)}: {out[-1500:]}"
    assert "Traceback" not in out + err, about + err
    result = json.loads(out.splitlines()[-1])
    assert code in (0, 1, 2, 3), about
    words_where_it_cannot_be(result, about)
    if record.is_file():
        sound(record, limits, about)
    return result["state"]


def words_where_it_cannot_be(result, about):
    """A reason, which is none of Python's."""
    if result["state"] == "refused":
        assert result["faults"] and all(fault["reason"]["text"] for fault in result["faults"]), about
    if result["state"] == "aborted":
        text = result["cause"]["text"]
        assert text, about
        assert "Error" not in text or any(own in text for own in OWN), about


def sound(record, limits, about):
    """What was measured are numbers, and joints were where they may be."""
    for name, series in Series.all_of(Reader(record)).items():
        variable = name.rpartition("/")[2]
        if variable not in MEASURED:
            continue
        rows = [values for _, values in series.flat()]
        assert all(math.isfinite(value) for row in rows for value in row), f"{variable} {about}"
        if variable == "Q_TRUE" and rows:  # none where a run ends before its first cycle
            stops_at_its_limits(rows, limits, about)


def stops_at_its_limits(rows, limits, about):
    """Each joint stays within its limits, but for how far it goes into a stop that it hits at its speed."""
    for joint, (low, high) in enumerate(limits):
        places = [row[joint] for row in rows]
        speed = max((abs(b - a) for a, b in pairwise(places)), default=0.0) / STEP_S
        soft = max(SOFT, speed * STOP_S / math.e)
        assert low - soft <= min(places) and max(places) <= high + soft, f"joint {joint} at {speed} {about}"


@pytest.mark.site
@pytest.mark.parametrize("seed", FEW)
def test_a_job_of_any_modules_runs_or_says_why_not(seed, tmp_path, capsys):  # R-K05, R-X14
    tried(seed, tmp_path, capsys)


@pytest.mark.site
@pytest.mark.slow
@pytest.mark.parametrize("seed", MANY)
def test_a_hundred_jobs_of_any_modules_run_or_say_why_not(seed, tmp_path, capsys):  # R-K05, R-X14
    tried(100 + seed, tmp_path, capsys)


@pytest.mark.site
@pytest.mark.parametrize("seed", FEW[:3])
def test_a_job_of_any_modules_on_an_arm_that_nobody_has_built_runs_or_says_why_not(seed, tmp_path, capsys):  # R-X19
    carried_out(seed, tmp_path, capsys, NAME, random_arm(tmp_path, seed).limits)


@pytest.mark.site
@pytest.mark.slow
@pytest.mark.parametrize("seed", MANY)
def test_a_hundred_jobs_on_as_many_arms_that_nobody_has_built_run_or_say_why_not(seed, tmp_path, capsys):  # R-X19
    carried_out(100 + seed, tmp_path, capsys, NAME, random_arm(tmp_path, 100 + seed).limits)
