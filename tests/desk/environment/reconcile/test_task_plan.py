import pytest

from kit.labs.library_site import LibrarySite, taken
from onika.desk.environment.reconcile.task_plan import SpawnPlan, birth, code_of, is_hardware, rate_of
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.configuration import Placed
from onika.model.task import LocalLine, Task, TaskType
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries
from onika.wire.plan import Code
from onika.words.reason import Reason

MOVE = Task("move", "mover", outvar=("Q",), frequency=100.0)
LONE = Task("lone", "loner", outvar=("P",), type=TaskType.APERIODIC)


@pytest.fixture
def libraries(tmp_path):
    bases = [BaseDirectory(tmp_path / "one"), BaseDirectory(tmp_path / "two")]
    for task in (MOVE, LONE):
        bases[0].save_task(RmodText(task))
    (tmp_path / "two" / "module").mkdir(parents=True)
    (tmp_path / "two" / "module" / "mover.py").write_text("far\n")
    return OpenLibraries(open_libraries(bases))


def test_a_task_is_born_with_its_code_and_the_rate_of_its_place(libraries, tmp_path):  # R-C11, reading 10
    (tmp_path / "one" / "module" / "mover.py").write_text("near\n")
    born = birth(Placed("move", frequency=40.0, rtpu="rt1"), libraries, ("rt0", "rt1"))
    assert isinstance(born, SpawnPlan)
    assert (born.task.frequency, born.task.rtpu, born.code.source) == (40.0, "rt1", "near\n")
    assert born.task.digest == born.code.digest and born.task.place.endswith("one/module/move.rmod")


def test_code_is_looked_for_in_the_other_libraries_too(libraries):  # R-C19
    assert code_of("mover", libraries, "move").source == "far\n"


def test_a_unit_that_the_runtime_lacks_means_its_first_one(libraries):  # reading 12
    assert birth(Placed("move", rtpu="elsewhere"), libraries, ("rt0",)).task.rtpu == "unknown"


def test_why_a_task_cannot_live_is_said(libraries, tmp_path):  # R-X01
    assert str(birth(Placed("lone"), libraries, ())) == (
        "lone cannot live: there is no loner.py beside it or in another open library"
    )
    assert str(birth(Placed("stranger"), libraries, ())) == "no open library has a task stranger"
    (tmp_path / "one" / "module" / "loner.py").write_bytes(b"\xff\xfe")
    assert "loner.py cannot be read" in str(birth(Placed("lone"), libraries, ()))


def test_a_task_without_a_rate_has_none_wherever_it_is_placed():
    assert rate_of(Placed("lone", frequency=50.0), LONE) is None
    assert rate_of(Placed("move"), MOVE) == 100.0


def test_whoever_names_a_device_moves_one_until_its_module_says_otherwise(libraries):  # law 22
    arm = Task("arm", "arm", local=(LocalLine("DEVICE", ("boxes:arm",)),))
    assert is_hardware(arm, libraries) and not is_hardware(MOVE, libraries)

    class Sheet:
        hardware = False

    assert not is_hardware(arm, OpenLibraries(sheets={"arm": Sheet()}))


def test_code_of_a_library_of_others_that_is_not_fetched_is_never_run(tmp_path):  # R-X16
    site = LibrarySite(tmp_path)
    site.publish()
    remote = taken(tmp_path, site)
    library = remote.listed()[0][0]
    libraries = OpenLibraries(open_libraries([BaseDirectory(remote.checkout(library).folder)]))
    lacking = code_of("wink", libraries, "wink")
    assert isinstance(lacking, Reason) and lacking.key == "store.code_not_fetched"
    remote.fetch(library)
    code = code_of("wink", libraries, "wink")
    assert isinstance(code, Code) and code.source == (site.base / "module/wink.py").read_text()
