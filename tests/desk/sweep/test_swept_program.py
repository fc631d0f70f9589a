import pytest

from onika.desk.plan.preparation import prepare_run
from onika.desk.run.settings import RunSettings
from onika.desk.sweep import swept_program
from onika.desk.sweep.design import SweepDesign
from onika.desk.sweep.swept_program import SweptProgram
from onika.store.site import open_site
from onika.words.condition import Condition

SITE = open_site([], {}, None)
ANSWERS = (("tell", "DURATION", "2"),)
SETTINGS = RunSettings(
    "go_home",
    is_virtual=True,
    has_black_box=False,
    expectations=(Condition.parse("LAMP == 0"),),
    settle_s=0.25,
    answers=ANSWERS,
)


def test_what_crosses_as_bytes_is_the_same_program_with_the_same_settings():  # R-X23
    prepared = prepare_run("go_home", SITE)
    design = SweepDesign(SETTINGS, range(3), is_shaken=False)
    crossed = swept_program.decode(swept_program.encode(SweptProgram.of(design, prepared)))
    assert crossed.prepared.plan == prepared.plan
    assert crossed.prepared.targets == prepared.targets
    assert crossed.prepared.faults == ()
    assert crossed.design == SweepDesign(SETTINGS, range(0), is_shaken=False)


def test_what_was_refused_is_no_program():  # R-X23
    with pytest.raises(ValueError, match="nowhere"):
        SweptProgram.of(SweepDesign(SETTINGS, range(3)), prepare_run("nowhere", SITE))
