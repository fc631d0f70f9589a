from typing import get_args

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.handlers import HANDLERS
from onika.wire import act


def test_every_act_has_its_handler():  # R-G04
    by_the_web = {act.Watch}  # of one browser, and no matter of the model
    assert set(HANDLERS) == set(get_args(act.AnyAct)) - by_the_web


def test_acts_that_both_kinds_of_documents_know_go_to_the_kind_their_id_says(tmp_path):  # R-D04
    gallery = AppFixture(tmp_path)
    conf, doc = gallery.do(act.New()), gallery.begun("grip")
    gallery.do(act.Save(conf, "same", str(gallery.base.path)))
    gallery.do(act.Save(doc, "same", str(gallery.base.path)))
    assert gallery.environment.tree.documents[conf].path.endswith("conf/same.conf")
    assert gallery.view(doc).path.endswith("appl/same.appl")
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == ""
    gallery.do(act.Redo(doc))
    assert str(gallery.no(act.Undo(conf)).reason) == "there is nothing to take back"
    for kind in (act.Keep, act.Reload, act.Close):
        gallery.do(kind(doc))
        gallery.do(kind(conf))
    assert gallery.do(act.Open(str(gallery.base.application_file("same")))).startswith("a")
    assert gallery.do(act.Open(str(gallery.base.configuration_file("same")))).startswith("c")
