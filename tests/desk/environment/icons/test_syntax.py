import pytest

from kit.desk.dictionary_fixture import WHITE, DictionaryFixture, plain
from kit.labs.laboratory import HOLE, Laboratory, job
from onika.wire import act

WELD = ("ONIKON Weld job", "LEFTEDGE 1", "RIGHTEDGE 7", "ONIKON Weld application", "LEFTEDGE 1", "RIGHTEDGE 7")
SPARK = ("ONIKON Weld object", "LEFTEDGE 7", "RIGHTEDGE 1", "VARNAME heat", "DATATYPE double", "NELEMS 2")


@pytest.fixture
def cabinet(tmp_path):
    Laboratory(tmp_path / "lab").application("seam", [job("weldC", "Weld job"), HOLE])
    return DictionaryFixture(tmp_path, plain("weldC", "Weld job"))


def test_new_types_appear_while_it_runs_by_editing_the_definition_alone(cabinet):  # R-D02, R-D16
    assert cabinet.icon("weldC").right == "1"  # it acts as a complete job
    cabinet.define(*WELD, *SPARK)
    assert cabinet.look() == 1
    tree = cabinet.environment.tree
    assert tree.types["Weld object"].items[0].name == "heat"
    assert cabinet.icon("weldC").right == "7" and cabinet.icon("weldC").takes == ("Weld object",)
    assert "Weld job" in tree.job_types
    assert "Weld job, Weld application, Weld target" in str(cabinet.says[-1].text)
    cabinet.do(act.MakeTarget("hot", "Weld object", (("1", "2"),), WHITE))
    assert cabinet.icon("hot").left == "7"


def test_applications_are_judged_by_the_new_definition(cabinet):  # R-D16
    path = str(cabinet.base.application_file("seam"))
    before = cabinet.environment.model.sources[path]
    cabinet.define(*WELD, *SPARK)
    cabinet.look()
    assert cabinet.environment.model.sources[path] != before
    assert cabinet.environment.model.sources[path].type == "Weld application"


def test_a_definition_at_fault_is_told_and_the_shipped_one_counts(cabinet):  # R-B07, reading 39
    path = cabinet.define(*WELD, *SPARK)
    cabinet.look()
    path.write_text("ONIKON\n")
    cabinet.look()
    assert "Weld job" not in cabinet.environment.tree.types
    assert any("OnikaUpperSetUp.dta" in str(say.text) for say in cabinet.says)
    path.unlink()
    assert cabinet.look() == 0  # the types are the shipped ones already


def test_a_definition_that_says_the_same_changes_nothing(cabinet):  # R-D02
    cabinet.define("# a comment")
    model = cabinet.environment.model
    assert cabinet.look() == 0 and cabinet.environment.model is model
