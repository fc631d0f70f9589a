from kit.desk.dictionary_fixture import DictionaryFixture, plain
from kit.labs.laboratory import Laboratory, job
from onika.desk.environment.icons.uses import users_of
from onika.wire import act


def test_applications_that_have_an_icon_are_named_open_ones_as_they_are_here(tmp_path):  # R-D05
    lab = Laboratory(tmp_path / "lab")
    lab.application("twice", [job("grip"), job("grip")])
    lab.application("never", [job("loosen")])
    cabinet = DictionaryFixture(tmp_path, plain("grip"))
    grip = plain("grip")
    assert users_of(cabinet.environment.model, grip) == ("twice",)
    doc = cabinet.do(act.NewApplication())
    cabinet.do(act.InsertIcon(doc, "grip"))
    assert users_of(cabinet.environment.model, grip) == ("Untitled-1", "twice")
    assert users_of(cabinet.environment.model, plain("grip", "Complete NOP")) == ()
