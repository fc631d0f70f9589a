import pytest

from kit.desk.dictionary_fixture import WHITE, DictionaryFixture, plain
from kit.labs.laboratory import HOLE, Laboratory, job
from onika.model.initials import drawn
from onika.model.onikon import Onikon
from onika.wire import act
from onika.wire.view import ShowSaveAs, ShowStep

MOVE = job("jmoveC", "Joint job")
SLIDE = job("cmoveC", "Cartesian job")


@pytest.fixture
def lab(tmp_path):
    return Laboratory(tmp_path / "lab")


def opened(tmp_path, lab, *flows, parallel=False, icons=()):
    lab.application("tour", *flows, parallel=parallel)
    cabinet = DictionaryFixture(tmp_path, *icons)
    return cabinet, cabinet.do(act.Open(str(cabinet.base.application_file("tour"))))


def test_an_application_without_holes_becomes_a_complete_application_at_once(tmp_path, lab):  # R-D09
    cabinet, doc = opened(tmp_path, lab, [job("opengripC")])
    drafted = cabinet.do(act.Draft(doc))
    assert (drafted.name, drafted.type, drafted.left_edge, drafted.right_edge) == (
        "tour",
        "Complete application",
        "1",
        "1",
    )
    assert (drafted.warnings, drafted.picture) == ((), "")
    path = cabinet.do(act.MakeJob(doc, WHITE, "look  around"))
    assert "an icon for other applications" in str(cabinet.says[-1].text)
    assert path == str(cabinet.base.onikon_file("tour"))
    view = cabinet.icon("tour")
    assert (view.role, view.description, str(view.trouble)) == ("application", "look around", "")
    assert view.source == str(cabinet.base.application_file("tour"))
    assert cabinet.look() == 0  # nobody waits for the next look at the disk


def test_holes_of_one_type_of_target_make_a_type_that_takes_it(tmp_path, lab):  # R-D09, reading 31
    cabinet, doc = opened(tmp_path, lab, [MOVE, HOLE, MOVE, HOLE])
    drafted = cabinet.do(act.Draft(doc))
    assert (drafted.type, drafted.right_edge) == ("Joint application", "2")
    assert tuple(map(str, drafted.warnings)) == ("the Joint target behind it fills 2 holes",)
    cabinet.do(act.MakeJob(doc, WHITE))
    assert cabinet.icon("tour").takes == ("Joint object",)


def test_holes_of_several_types_make_one_that_takes_several(tmp_path, lab):  # R-D09, R-D13
    cabinet, doc = opened(tmp_path, lab, [MOVE, HOLE, SLIDE, HOLE], parallel=True)
    cabinet.do(act.MakeJob(doc, WHITE))
    assert cabinet.icon("tour").takes == ("Joint object", "Cartesian object")


def test_a_hole_for_an_action_is_refused_with_the_way_to_it(tmp_path, lab):  # R-D09, R-X01
    cabinet, doc = opened(tmp_path, lab, [job("opengripC"), HOLE, MOVE, HOLE])
    no = cabinet.no(act.Draft(doc))
    assert "no place for a target" in str(no.reason)
    application = cabinet.environment.model.applications[doc].application
    numbers = [step.number for step in application.flows[0].steps]
    shows = [remedy.show for remedy in no.remedies]
    assert shows == [ShowStep(numbers[1]), ShowStep(numbers[3])]
    assert str(cabinet.no(act.MakeJob(doc, WHITE)).reason) == str(no.reason)


def test_what_is_wrong_is_told_as_in_the_list_beside_the_application(tmp_path, lab):  # R-D09, R-X01
    cabinet, doc = opened(tmp_path, lab, [job("opengripC"), HOLE], [], parallel=True)
    assert str(cabinet.no(act.Draft(doc)).reason).startswith("flow 1 is empty; a hole, ")


def test_it_is_made_of_what_its_file_says(tmp_path, lab):  # R-D09
    cabinet, doc = opened(tmp_path, lab, [job("opengripC")])
    cabinet.do(act.InsertIcon(doc, "closegripC"))
    no = cabinet.no(act.Draft(doc))
    assert "has changed since it was saved" in str(no.reason) and no.remedies[0].act == act.Save(doc)
    cabinet.do(no.remedies[0].act)
    assert cabinet.do(act.Draft(doc)).type == "Complete application"
    new = cabinet.do(act.NewApplication())
    assert cabinet.no(act.Draft(new)).remedies[0].show == ShowSaveAs()


def test_the_icon_of_a_configuration_is_replaced_only_where_that_is_meant(tmp_path, lab):  # reading 34
    cabinet, doc = opened(tmp_path, lab, [job("opengripC")], icons=(plain("tour"),))
    assert "icon of something else" in str(cabinet.do(act.Draft(doc)).warnings[0])
    no = cabinet.no(act.MakeJob(doc, WHITE))
    cabinet.do(no.remedies[0].act)
    assert cabinet.icon("tour").type == "Complete application"


def test_the_former_picture_and_what_it_says_are_offered_again(tmp_path, lab):  # R-D09, R-X11, reading 36
    words = (("es", "visita"),)
    icon = Onikon("tour", "Joint application", "go", (), drawn("V"), (), words)
    cabinet, doc = opened(tmp_path, lab, [job("opengripC")], icons=(icon,))
    assert "makes a Complete application now" in str(cabinet.icon("tour").trouble)
    drafted = cabinet.do(act.Draft(doc))
    assert (drafted.picture, drafted.description) == ("".join(drawn("V").rows), "go")
    assert tuple(map(str, drafted.warnings)) == ("its icon says Joint application, as it was before",)
    cabinet.do(act.MakeJob(doc, drafted.picture, "go", overwrites=True))
    assert (str(cabinet.icon("tour").trouble), cabinet.icon("tour").words) == ("", {"es": "visita"})
    cabinet.do(act.MakeJob(doc, drafted.picture, "stay", overwrites=True))
    assert cabinet.icon("tour").words == {}


def test_one_that_stands_in_itself_is_told(tmp_path, lab):  # R-D13
    cabinet, doc = opened(tmp_path, lab, [job("tour", "Complete application")])
    assert "stands in itself" in str(cabinet.do(act.Draft(doc)).warnings[0])
