from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.station_focus import located, of_station, station_of
from onika.model.configuration import Configuration
from onika.wire import act, page
from onika.wire.view import Remedy, RuntimeView, ShowConnect
from onika.words.reason import NOTHING, Reason


def test_an_act_is_about_the_station_that_it_names_or_that_of_its_configuration():  # R-F02
    model = Model().with_document(Document("c1", Content(Configuration("c")), station="cmu"))
    for command, station in (
        (act.Toggle("c1", "a"), "cmu"),
        (act.Toggle("c2", "a"), ""),
        (act.Take("c1"), "cmu"),
        (act.Take(subsystem="main", station="sandia"), "sandia"),
        (act.Scene("boxes"), ""),
        (act.Scene("cmu/boxes"), "cmu"),
        (act.SampleVariables(("c1/Q",)), "cmu"),
        (act.SampleVariables(("@flow0@sandia/Q",)), "sandia"),
        (act.SampleVariables(("@flow0/Q",)), ""),
        (act.Stop(), ""),
    ):
        assert station_of(model, command) == station, command


def test_what_can_be_done_instead_is_done_at_the_same_station():  # R-F02, X01
    remedies = (
        Remedy(NOTHING, act.Reset()),
        Remedy(NOTHING, act.Reset("sandia")),
        Remedy(NOTHING, act.Undo("c1")),
        Remedy(NOTHING, show=ShowConnect()),
    )
    there = located(No(NOTHING, remedies), "cmu").remedies
    assert [remedy.act for remedy in there] == [act.Reset("cmu"), act.Reset("sandia"), act.Undo("c1"), None]
    assert located(No(NOTHING, remedies), "").remedies == remedies


def test_lines_without_a_file_name_the_station_that_tells_them():  # R-F02
    says = (page.Say("error", Reason.plain("stopped")), page.Say("info", Reason.plain("it is on"), "c1"))
    model = Model().with_station("cmu", RuntimeView())
    assert [str(say.text) for say in of_station(Done(model.at("cmu"), says=says)).says] == ["cmu: stopped", "it is on"]
    assert of_station(Done(model, says=says)).says == says
