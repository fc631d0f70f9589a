from xml.etree import ElementTree

from onika.desk.trial.judging import Verdict
from onika.desk.trial.junit import document
from onika.desk.trial.trial import Trial
from onika.words.reason import Reason

TRIALS = [
    Trial("a.test", Verdict((), (Reason.plain("a note & more"),)), 1.25),
    Trial("b.test", Verdict((Reason.plain("Q_MEZ: expected <1>"), Reason.plain("LAMP \x00"))), 0.5, shake=2),
]


def test_a_build_server_reads_how_many_failed_and_why():  # R-X07
    root = ElementTree.fromstring(document(TRIALS))
    (suite,) = root
    assert (suite.get("tests"), suite.get("failures"), suite.get("time")) == ("2", "1", "1.750")
    good, bad = suite
    assert (good.get("name"), good.findtext("system-out"), good.find("failure")) == ("a.test", "a note & more", None)
    assert bad.find("failure").get("message") == "Q_MEZ: expected <1>"
    assert (bad.get("name"), bad.findtext("failure")) == ("b.test shaken 2", "Q_MEZ: expected <1>\nLAMP \ufffd")


def test_no_tests_are_a_document_too():
    assert ElementTree.fromstring(document([]))[0].get("tests") == "0"
