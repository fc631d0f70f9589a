from dataclasses import asdict

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.preferences import leave
from onika.desk.environment.state import settings
from onika.files import preferences as file
from onika.model.preferences import STATUS_COLUMNS, Preferences, Window
from onika.model.task import Task
from onika.wire import act


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (Task("pd", "pd", invar=("Q",), outvar=("TAU",), frequency=100.0),))


def preferred(sitting):
    return sitting.environment.model.preferences


def test_a_page_sees_the_preferences_that_change_something_by_their_names(sitting):  # R-G01
    sizes = ("line_length", "min_size", "min_pin_separation", "step_size", "pin_length", "connection_separation")
    choices = (
        "locus_size",
        "hit_tolerance",
        "show_inconst",
        "show_outconst",
        "show_invar",
        "show_outvar",
        "shows_period",
        "status_columns",
    )
    usual = asdict(Preferences())
    assert sitting.environment.tree.preferences == {name: usual[name] for name in (*sizes, *choices)} | {
        "shows_warnings": True,
        "keeps_diary": True,
        "shows_lower": True,
        "angle_unit": "rad",
        "length_unit": "m",
        "presentation": "",
        "places": {},
    }


def test_windows_that_were_moved_are_kept_and_are_no_step_to_take_back(sitting):  # R-G01
    place = {"x": 0, "y": 0, "height": 650, "width": 300}
    sitting.do(act.Prefer({"places": {"library": place}}))
    assert preferred(sitting).library == Window(0, 0, 650, 300)
    assert sitting.environment.tree.preferences["places"] == {"library": place}
    assert sitting.no(act.Undo("")).reason.key
    assert sitting.no(act.Prefer({"places": {"library": {"x": 0}}})).fields["places"].key == "run.place_form"
    assert preferred(sitting).library.width == 300


def test_units_to_read_are_chosen_out_of_those_that_are_known(sitting):  # R-G08
    sitting.do(act.Prefer({"angle_unit": "deg", "length_unit": "mm"}))
    settings_now = sitting.environment.model.settings
    assert (settings_now.angle_unit, settings_now.length_unit) == ("deg", "mm")
    for value in ("furlong", "mm", 1, None, ["deg"]):
        assert sitting.no(act.Prefer({"angle_unit": value})).fields["angle_unit"].key == "run.one_of"
    sitting.do(act.Undo(""))
    assert sitting.environment.model.settings.angle_unit == "rad"


def test_preferences_of_every_kind_are_changed(sitting):  # R-G01
    values = {
        "pin_length": 20,
        "shows_period": True,
        "status_columns": ["rmod", "tick"],
        "keeps_diary": False,
    }
    sitting.do(act.Prefer(values))
    now = preferred(sitting)
    assert (now.pin_length, now.shows_period) == (20, True)
    assert now.status_columns == ("rmod", "tick")
    assert sitting.environment.model.settings.keeps_diary is False


@pytest.mark.parametrize(
    ("name", "value", "key"),
    [
        ("pin_length", 0, "run.number_range"),
        ("pin_length", 10_001, "run.number_range"),
        ("pin_length", 1.5, "run.whole_number"),
        ("pin_length", float("nan"), "run.whole_number"),
        ("pin_length", float("inf"), "run.whole_number"),
        ("pin_length", True, "run.whole_number"),
        ("pin_length", "12", "run.whole_number"),
        ("shows_period", 1, "run.yes_or_no"),
        ("shows_warnings", "yes", "run.yes_or_no"),
        ("canvas", {"x": 1}, "run.no_preference"),
        ("workspace", 20, "run.no_preference"),
        ("status_columns", ["rmod", "rmod"], "run.columns_once"),
        ("status_columns", ["colour"], "run.columns_unknown"),
        ("status_columns", [3], "run.columns_unknown"),
        ("status_columns", [["rmod"]], "run.columns_unknown"),
        ("status_columns", "rmod", "run.columns_once"),
        ("theme", "1994", "run.no_preference"),
    ],
)
def test_what_cannot_be_is_named_by_its_field_and_nothing_is_changed(sitting, name, value, key):  # R-G01, R-B12
    no = sitting.no(act.Prefer({"locus_size": 30, name: value}))
    assert {field: reason.key for field, reason in no.fields.items()} == {name: key}
    assert preferred(sitting) == Preferences()


def test_icons_take_their_new_sizes_at_once_and_loci_stay(sitting):  # R-G01, R-C02
    doc = sitting.new("pd")
    loci = sitting.environment.tree.documents[doc].loci
    sitting.do(act.Prefer({"min_size": 300}))
    assert sitting.environment.tree.tasks["pd"].height == 300
    assert sitting.environment.tree.documents[doc].loci == loci
    assert str(sitting.environment.tree.documents[doc].undo) == "changing preferences"


def test_the_users_file_is_written_at_once_where_there_is_one(sitting):  # R-B12
    sitting.home.mkdir()
    path = sitting.home / file.NAME
    path.write_text("LINELEN 20\n# mine\nEOF\n")
    sitting.do(act.Prefer({"pin_length": 20, "shows_warnings": False}))
    kept, _ = file.read(path.read_text(), "p", "p")
    assert (kept.line_length, kept.pin_length) == (20, 20)
    assert "# mine" in path.read_text()
    assert settings.read(sitting.surroundings.state, {})[0].shows_warnings is False


def test_without_a_file_it_is_written_at_the_end(sitting):  # R-B12
    sitting.do(act.Prefer({"pin_length": 20}))
    assert not (sitting.home / file.NAME).exists()
    assert leave(sitting.environment.model, sitting.surroundings) is None
    kept, _ = file.read((sitting.home / file.NAME).read_text(), "p", "p")
    assert kept.pin_length == 20


def test_a_file_with_faults_is_left_as_it_is_and_the_change_holds_for_the_session(sitting):  # R-B12, R-B07
    sitting.home.mkdir()
    path = sitting.home / file.NAME
    path.write_text("PINLENGTH twelve\nEOF\n")
    sitting.do(act.Prefer({"locus_size": 30}))
    assert path.read_text() == "PINLENGTH twelve\nEOF\n"
    assert preferred(sitting).locus_size == 30
    (say,) = sitting.says
    assert say.level == "warning"
    assert "PINLENGTH" in str(say.text)


def test_where_nothing_can_be_written_it_is_said(sitting):  # R-B12
    sitting.home.write_text("no directory")
    sitting.surroundings.state.write_text("no directory")
    sitting.do(act.Prefer({"keeps_diary": False}))
    assert ["holds for this session" in str(say.text) for say in sitting.says] == [True]
    assert leave(sitting.environment.model, sitting.surroundings).reason.key == "files.not_savable"


def test_every_column_may_be_shown(sitting):  # R-G01
    sitting.do(act.Prefer({"status_columns": list(STATUS_COLUMNS)}))
    assert preferred(sitting).status_columns == STATUS_COLUMNS


def test_no_act_changes_how_icons_are_presented_in_a_study(tmp_path):  # R-H04
    sitting = EnvironmentFixture(tmp_path)
    assert "presentation" in sitting.no(act.Prefer({"presentation": "pictures"})).fields
    assert sitting.environment.tree.preferences["presentation"] == ""
