from onika.desk.run.settings import RunSettings
from onika.desk.sweep.case import Case
from onika.desk.sweep.design import SweepDesign
from onika.desk.sweep.variation import Variation
from onika.model.redirect import Redirect
from onika.words.condition import Condition

STIFF = Variation.parse("pd.STIFF=1..2")


def test_each_seed_is_a_run_with_numbers_of_its_own_whatever_the_other_seeds_are():  # R-X23
    cases = list(SweepDesign(RunSettings("stack"), range(5), (STIFF,)).cases())
    assert [case.seed for case in cases] == [0, 1, 2, 3, 4]
    assert len({case.values["pd.STIFF"] for case in cases}) == 5
    assert list(SweepDesign(RunSettings("stack"), range(3, 5), (STIFF,)).cases()) == cases[3:]


def test_a_run_is_shaken_by_its_seed_where_that_is_wanted():  # R-X23
    case = Case(3, {"pd.STIFF": 1.5})
    shaken = SweepDesign(RunSettings("stack", is_virtual=True), range(5)).settings_of(case)
    assert shaken == RunSettings("stack", is_virtual=True, seed=3, shake=3, values=(("pd.STIFF", 1.5),))
    assert SweepDesign(RunSettings("stack"), range(5), is_shaken=False).settings_of(case).shake is None


def test_the_command_says_all_that_the_runs_have_in_common():  # R-X23
    settings = RunSettings(
        "stack",
        expectations=(Condition.parse("LAMP == 1"),),
        redirects=(Redirect.parse("puma=scara"),),
        answers=(("hand", "FORCE", "3"),),
    )
    design = SweepDesign(settings, range(5), (STIFF,), is_shaken=False)
    assert " ".join(design.command) == (
        "stack --vary pd.STIFF=1..2 --expect LAMP == 1 --redirect puma=scara --answer hand.FORCE=3 "
        "--settle 0.5 --no-shake"
    )
