from onika.desk.environment.outcome.remedy import overwriting, reasons, unreadable
from onika.model.rules import placement
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import ShowPin, ShowTask
from onika.words.fault import Fault, Place, Refusal
from onika.words.reason import Reason

CUBIC = Task("cubic", "cubic", outvar=("Q_REF",))
TRAPEZ = Task("trapez", "trapez", outvar=("Y",), aliases=(("Y", "Q_REF"),))


def test_a_refusal_becomes_a_sentence_with_buttons():  # R-X01
    (reason,) = reasons(placement.refusals(TRAPEZ, [CUBIC]), "c1", TRAPEZ)
    assert str(reason.text) == "writes Q_REF, which `cubic` already writes"
    replaces, alias, shows = reason.remedies
    assert (str(replaces.label), replaces.act) == ("Replace cubic", act.Exchange("c1", "cubic", "trapez"))
    assert (str(alias.label), alias.act, alias.show) == ("Alias Q_REF…", None, ShowPin("trapez", "Y"))
    assert (str(shows.label), shows.show) == ("Show cubic", ShowTask("cubic"))


def test_another_alias_is_given_at_its_pin():  # R-X01, reading 9
    task = Task("t", "t", aliases=(("A", "B"),), outvar=("A", "B"))
    (reason,) = reasons(placement.alias_refusals(task, ()), "c1", task)
    assert [(str(remedy.label), remedy.show) for remedy in reason.remedies] == [("Alias B…", ShowPin("t", "B"))]


def test_to_overwrite_is_offered_only_where_that_would_help():  # R-X01
    again = act.Save("a1", overwrites=True)
    full, removed_since = Reason.plain("the disk is full"), Reason.of("files.removed_since", path="a.conf")
    elsewhere, all_the_same = Reason.of("files.save_elsewhere"), Reason.of("files.save_all_the_same")
    assert overwriting(Refusal(full, (elsewhere,)), again) == ()
    (removed,) = overwriting(Refusal(removed_since, (all_the_same, elsewhere)), again)
    (there,) = overwriting(Refusal(Reason.plain("it is there"), (elsewhere, Reason.of("files.overwrite"))), again)
    assert (str(removed.label), str(there.label)) == ("Save it all the same", "Overwrite it")
    assert removed.act == there.act == again


def test_a_file_with_a_thousand_faults_is_refused_in_a_few_sentences():  # R-X01
    faults = [
        Fault(Place("many.appl", line), Reason.plain("expected a keyword, found none"), Reason.plain("it is left out"))
        for line in range(1, 1001)
    ]
    sentence = str(unreadable("many.appl", faults))
    assert "many.appl:4: expected a keyword" in sentence
    assert sentence.endswith("; and 996 more, see onika check")
    assert unreadable("many.appl", faults[:4]).key == "run.cannot_be_opened"
