from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.refresh import refreshed
from onika.desk.environment.show.tree import Projector
from onika.desk.environment.show.tree_difference import difference
from onika.model.task import Task
from onika.wire import act

TASKS = (Task("a", "a", outvar=("Q",), frequency=1.0), Task("b", "b", invar=("Q",), frequency=1.0))


def test_what_has_not_changed_is_the_same_object_again(tmp_path):
    sitting = EnvironmentFixture(tmp_path, TASKS)
    doc = sitting.new("a", "b")
    before = sitting.environment.tree
    sitting.do(act.Move(doc, {"a": (5, 5)}))
    after = sitting.environment.tree
    assert after.tasks is before.tasks
    assert after.documents[doc].greyed is before.documents[doc].greyed
    assert after.documents[doc].tasks["b"] is before.documents[doc].tasks["b"]
    assert after.documents[doc].tasks["a"] != before.documents[doc].tasks["a"]


def test_a_tree_remembered_is_the_tree_made_anew(tmp_path):
    sitting = EnvironmentFixture(tmp_path, TASKS)
    doc = sitting.new("a", "b")
    sitting.do(act.Flip(doc, ("a",)))
    assert sitting.environment.tree == Projector().project(sitting.environment.model)


def test_nothing_of_a_closed_document_is_kept(tmp_path):  # R-C06
    sitting = EnvironmentFixture(tmp_path, TASKS)
    projector, docs = Projector(), [sitting.new("a"), sitting.new("b"), sitting.new("a", "b")]
    projector.project(sitting.environment.model)
    sitting.do(act.Close(docs[0], discards=True))
    assert projector.project(sitting.environment.model) == sitting.environment.tree
    assert docs[0] not in repr(vars(projector).keys() | projector._made.keys() | projector._seen.keys())
    assert docs[1] in sitting.environment.tree.documents


def test_what_modules_say_in_other_languages_travels_in_the_tree_a_sentence_at_a_time(tmp_path):
    catalogues = {name: tmp_path / "module" / f"{name}.es.toml" for name in ("door", "lamp")}
    (tmp_path / "module").mkdir()
    for name, path in catalogues.items():
        path.with_name(f"{name}.py").write_text("")
        path.write_text('"on" = "conectada"\n"off" = "desconectada"\n')
    environment = EnvironmentFixture(tmp_path, TASKS).environment
    before = environment.tree
    opened = {"es": {"on": "conectada", "off": "desconectada"}}
    assert before.module_sentences == {"door": opened, "lamp": opened}
    catalogues["lamp"].write_text('"on" = "encendida"\n"off" = "desconectada"\n')
    environment.become(lambda model: refreshed(model, {catalogues["lamp"]}))
    path = ("module_sentences", "lamp", "es", "on")
    assert difference(before, environment.tree) == [(path, "encendida")]
