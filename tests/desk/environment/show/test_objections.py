from dataclasses import replace

import pytest

from onika.desk.environment.show.objections import objections
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.task import LocalLine, Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries
from onika.wire import act
from onika.wire.sheet import ModuleSheet, PortSheet
from onika.wire.view import ShowPin, ShowTask

DEVICE = (LocalLine("DEVICE", ("boxes:left",)),)
TASKS = (
    Task("reader", "reader", invar=("X",), frequency=1.0),
    Task("writer", "writer", aliases=(("OUT", "X"),), outvar=("OUT",), frequency=1.0),
    Task("arm", "arm", invar=("A",), frequency=100.0, local=DEVICE),
    Task("other_arm", "other_arm", invar=("B",), frequency=100.0, local=DEVICE),
    Task("unknown", "unknown", invar=("X",), frequency=1.0),
)


def sheet(*ports, hardware=False):
    return ModuleSheet(ports, (), (), False, False, hardware, 0, "")


SHEETS = {
    "reader": sheet(PortSheet("INVAR", "X", "double[6]", "rad", "")),
    "writer": sheet(PortSheet("OUTVAR", "OUT", "double[6]", "m", "")),
    "arm": sheet(PortSheet("INVAR", "A", "double", "m", ""), hardware=True),
    "other_arm": sheet(PortSheet("INVAR", "B", "double", "m", ""), hardware=True),
}


@pytest.fixture
def libraries(tmp_path):
    base = BaseDirectory(tmp_path)
    for task in TASKS:
        base.save_task(RmodText(task))
    return OpenLibraries(open_libraries([base]), sheets=SHEETS)


def document(*names):
    return Document("c1", Content(Configuration("c", tuple(Placed(name) for name in names))))


def test_a_task_that_takes_a_variable_for_something_else_is_objected_to(libraries):  # law 7, R-X01
    views = objections(document("reader"), libraries)
    assert set(views) == {"writer"}
    (reason,) = views["writer"]
    assert str(reason.text) == "takes X for double[6] in m, `reader` for double[6] in rad"
    assert [remedy.show for remedy in reason.remedies] == [ShowPin("writer", "OUT"), ShowTask("reader")]


def test_a_second_master_of_a_device_is_objected_to(libraries):  # law 16
    (reason,) = objections(document("arm"), libraries)["other_arm"]
    assert str(reason.text) == "moves boxes:left, which `arm` moves already"
    assert reason.remedies[0].act == act.Exchange("c1", "arm", "other_arm")


def test_what_no_runtime_has_read_is_not_judged(libraries):
    assert objections(document("unknown"), replace(libraries, sheets={})) == {}
    assert objections(document("writer", "unknown"), libraries).keys() == {"reader"}


def test_what_stands_already_and_what_stands_alone_is_not_objected_to(libraries):
    assert objections(document("reader", "writer"), libraries) == {}
    assert objections(document(), libraries) == {}
