import pytest

from kit.desk.dictionary_fixture import DictionaryFixture, plain
from kit.labs.laboratory import HOLE, Laboratory, job
from onika.words.reason import NOTHING

TASK = """MODULE {0}\nDESC x\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR none\nTASKTYPE periodic\nFREQ 10\n{1}"""


@pytest.fixture
def lab(tmp_path):
    lab = Laboratory(tmp_path / "lab")
    lab.task("go", TASK.format("go", "ONIKA\nOBJECT Joint job"))
    lab.configuration("goC", "go 10")
    return lab


def test_an_icon_whose_configuration_or_application_is_missing_says_so(tmp_path, lab):  # R-X01
    cabinet = DictionaryFixture(
        tmp_path, plain("lost"), plain("gone", "Complete application"), plain("rest", "Complete NOP")
    )
    assert str(cabinet.icon("lost").trouble) == "there is no configuration lost"
    assert str(cabinet.icon("gone").trouble) == "there is no application gone"
    assert (cabinet.icon("rest").trouble, cabinet.icon("rest").source) == (NOTHING, "")
    lab.configuration("lost", "opengrip 100")
    cabinet.look()
    assert str(cabinet.icon("lost").trouble) == ""
    assert cabinet.icon("lost").source == str(cabinet.base.configuration_file("lost"))


def test_an_icon_that_says_another_type_than_is_made_now_says_so_as_soon_as_that_is_so(tmp_path, lab):  # reading 36
    cabinet = DictionaryFixture(tmp_path, plain("goC", "joint JOB"), plain("jmoveC", "Complete job"))
    assert str(cabinet.icon("goC").trouble) == ""
    assert "makes a Joint job now, not a Complete job" in str(cabinet.icon("jmoveC").trouble)
    lab.task("go", TASK.format("go", "ONIKA\nOBJECT Joint job\nTARGET Pause object"))
    cabinet.look()
    assert "makes a Joint job with a Pause target now, not a" in str(cabinet.icon("goC").trouble)
    lab.task("go", "MODULE")
    cabinet.look()
    assert "the task go of `goC` is missing" in str(cabinet.icon("goC").trouble)
    cabinet.base.configuration_file("goC").write_text("NONSENSE\n")
    cabinet.look()
    assert "is at fault" in str(cabinet.icon("goC").trouble)


def test_the_icon_of_an_application_is_judged_by_its_holes(tmp_path, lab):  # R-D09, reading 36
    lab.application("visit", [job("goC", "Joint job"), HOLE])
    cabinet = DictionaryFixture(tmp_path, plain("visit", "Joint application"))
    assert str(cabinet.icon("visit").trouble) == ""
    lab.application("visit", [job("goC", "Joint job"), HOLE, job("goC", "Pause job"), HOLE])
    cabinet.look()
    assert "Joint application with a Pause target" in str(cabinet.icon("visit").trouble)
    lab.application("visit", [HOLE])
    cabinet.look()
    assert "no place for a target" in str(cabinet.icon("visit").trouble)


def test_what_stands_beside_the_icon_counts_before_the_search_path(tmp_path, lab):  # reading 35
    other = Laboratory(tmp_path / "home" / "onika")
    other.configuration("opengripC", "go 10")
    cabinet = DictionaryFixture(tmp_path)
    shipped = cabinet.icon("opengripC")
    assert shipped.source.endswith("puma/conf/opengripC.conf") and not shipped.trouble
    cabinet.own.save_onikon(plain("opengripC", "Joint job"))
    cabinet = DictionaryFixture(tmp_path)
    assert cabinet.icon("opengripC").source == str(cabinet.own.configuration_file("opengripC"))
    assert str(cabinet.icon("opengripC").trouble) == ""


def test_no_shipped_icon_is_in_trouble(tmp_path):  # R-B08
    icons = DictionaryFixture(tmp_path).environment.tree.onikons
    assert {name: icon.trouble for name, icon in icons.items() if icon.trouble} == {}
