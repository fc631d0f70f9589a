from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.clash import clashes, refused
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import Objection, Remedy, ShowTask
from onika.words.reason import Reason

W = Task("w", "w", outvar=("Q",), frequency=1.0)
C = Task("c", "c", inconst=("K",), frequency=1.0)


def aliased(task, pin, svar):
    return Task(task.name, task.module, aliases=((pin, svar),), inconst=task.inconst, outvar=task.outvar, frequency=1.0)


def test_a_pure_outvar_that_would_meet_a_pure_inconst_speaks_against_an_alias(tmp_path):  # reading 9, Equation (3)
    sitting = EnvironmentFixture(tmp_path, (W, C))
    doc = sitting.new("w", "c")
    model = sitting.environment.model
    (reason,) = clashes(model, model.libraries.edited({"w": aliased(W, "Q", "K")}), ("w",))
    name = model.documents[doc].name
    assert str(reason.text) == f"in {name}, `c` needs K at initialisation, `w` gives it only while it runs"
    assert [str(remedy.label) for remedy in reason.remedies] == [f"Remove c from {name}", "Alias K of c…", "Show c"]
    assert reason.remedies[0].act == act.Remove(doc, ("c",))


def test_what_speaks_against_it_already_is_no_reason_against_a_change(tmp_path):  # reading 9
    reader = Task("c", "c", aliases=(("K", "Q"),), inconst=("K",), invar=("P",), frequency=1.0)
    sitting = EnvironmentFixture(tmp_path, (W, reader))
    (tmp_path / "conf").mkdir()
    text = "VERSION 1.2\nRMODFILE w\nCOORDS 1 2\nRMODFILE c\nCOORDS 1 2\nEOF\n"
    (tmp_path / "conf" / "odd.conf").write_text(text)
    sitting.do(act.Open("odd"))
    model = sitting.environment.model
    moved = Task("c", "c", aliases=(("K", "Q"), ("P", "R")), inconst=("K",), invar=("P",), frequency=1.0)
    assert clashes(model, model.libraries.edited({"c": moved}), ("c",)) == ()


def test_a_no_names_all_reasons_and_each_way_out_once():  # R-X01
    show = Remedy(Reason.plain("Show a"), show=ShowTask("a"))
    no = refused(
        Reason.plain("it cannot be"),
        (Objection(Reason.plain("one"), (show,)), Objection(Reason.plain("two"), (show,))),
        "svar",
    )
    assert (str(no.reason), no.remedies) == ("it cannot be: one; two", (show,))
    assert {field: str(why) for field, why in no.fields.items()} == {"svar": "one; two"}
    assert refused(Reason.plain("it cannot be"), (Objection(Reason.plain("one")),)).fields == {}
