import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.task import Task
from onika.store.library import open_libraries
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.wire import act
from onika.wire.view import PeekView

GIVES = Task("gives", "gives", outvar=("Q",), outconst=("NDOF",), frequency=10.0)
TAKES = Task("takes", "takes", invar=("Q",), inconst=("NDOF",), frequency=10.0)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (GIVES, TAKES))


def test_a_configuration_is_seen_in_small_without_being_opened(sitting):  # R-G05
    doc = sitting.new("gives", "takes")
    path = sitting.do(act.Save(doc, "both", str(sitting.base.path)))
    sitting.do(act.Move(doc, {"gives": (7, 8)}, {}))
    before = sitting.environment.model
    seen = sitting.do(act.Peek(path))
    box = sitting.environment.tree.tasks["gives"]
    assert (seen.name, seen.tasks["gives"]) == ("both", (0, 100, box.width, box.height))
    assert seen.wires == (("gives", "takes"),)
    assert sitting.environment.model is before


def test_a_task_that_no_library_has_is_a_box_without_wires(sitting):  # R-G05
    path = sitting.do(act.Save(sitting.new("gives", "takes"), "both", str(sitting.base.path)))
    (sitting.base.path / "module" / "takes.rmod").unlink()
    fixture = EnvironmentFixture(sitting.base.path, model=Model(OpenLibraries(open_libraries([sitting.base]))))
    seen = fixture.do(act.Peek(path))
    assert (seen.tasks["takes"][2:], seen.wires) == ((136, 64), ())


def test_what_cannot_be_read_is_refused_with_its_reason(sitting):  # R-G05, R-X01
    assert "there is no file" in str(sitting.no(act.Peek(str(sitting.base.path / "conf" / "none.conf"))).reason)
    assert "syntax" in str(sitting.no(act.Peek("/a/appl/b.appl")).reason)


def test_an_application_is_its_first_icons_with_their_edges(tmp_path):  # R-G05
    boxes = shipped() / "boxes"
    syntax, _ = Site((), shipped() / "prefs", None).syntax()
    seen = EnvironmentFixture(tmp_path, model=Model(syntax=syntax)).do(act.Peek(str(boxes / "appl" / "assemble.appl")))
    assert isinstance(seen, PeekView) and seen.name == "assemble"
    (flow,) = seen.flows
    assert len(flow) == 12 and all(len(icon.picture) == 1024 for icon in flow)
    assert all(icon.right for icon in flow)
