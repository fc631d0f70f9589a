from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.task import Task
from onika.wire import act

TASKS = (
    Task(
        "a",
        "a",
        "makes Q",
        inconst=("KP",),
        outvar=("Y",),
        aliases=(("Y", "Q"),),
        frequency=5.0,
        object_type="Joint job",
    ),
    Task("b", "b", invar=("Q",), outconst=("KP",), frequency=1.0),
)


def test_a_library_task_is_drawn_from_its_file(tmp_path):  # R-C01, R-C02, R-C23
    view = EnvironmentFixture(tmp_path, TASKS).environment.tree.tasks["a"]
    assert (view.description, view.hz, view.object_type, view.is_trigger) == ("makes Q", 5.0, "Joint job", True)
    assert [(pin.name, pin.svar, pin.kind) for pin in view.pins] == [("KP", "KP", "INCONST"), ("Y", "Q", "OUTVAR")]
    assert view.path.endswith("a.rmod")


def test_a_file_at_fault_is_left_out_and_told(tmp_path):  # R-C01
    (tmp_path / "module").mkdir()
    (tmp_path / "module" / "bad.rmod").write_text("nothing\n")
    tree = EnvironmentFixture(tmp_path, TASKS).environment.tree
    (library,) = tree.libraries.values()
    assert (sorted(tree.tasks), library.tasks) == (["a", "b"], 2)
    assert any("bad.rmod" in str(fault) for fault in library.faults)


def test_libraries_in_which_nothing_is_to_be_seen_come_last(tmp_path):  # R-C01
    (tmp_path / "a" / "conf").mkdir(parents=True)
    sitting = EnvironmentFixture(tmp_path / "a", ())
    for name, text in (("b", "nothing"), ("c", "")):
        (tmp_path / name / "module").mkdir(parents=True)
        (tmp_path / name / "module" / ("bad.rmod" if text else "note")).write_text(text)
        sitting.do(act.OpenLibrary(str(tmp_path / name)))
    libraries = sitting.environment.tree.libraries.values()
    assert [library.name for library in sorted(libraries, key=lambda library: library.order)] == ["b", "a", "c"]


def test_without_a_runtime_there_is_no_state_and_every_line_is_idle(tmp_path):  # R-C25
    sitting = EnvironmentFixture(tmp_path, TASKS)
    doc = sitting.new("a", "b")
    document = sitting.environment.tree.documents[doc]
    assert {task.state for task in document.tasks.values()} == {""}
    assert {locus.line for locus in document.loci.values()} == {"idle"}


def test_constants_are_told_from_variables(tmp_path):  # R-C09
    sitting = EnvironmentFixture(tmp_path, TASKS)
    doc = sitting.new("a", "b")
    loci = sitting.environment.tree.documents[doc].loci
    assert {svar: locus.is_constant for svar, locus in loci.items()} == {"KP": True, "Q": False}
    assert (loci["KP"].writers, loci["KP"].readers) == (("b",), ("a",))


def test_a_task_that_no_library_knows_is_shown_as_missing(tmp_path):
    sitting = EnvironmentFixture(tmp_path, TASKS)
    doc = sitting.new("a")
    path = sitting.do(act.Save(doc, "mine", str(tmp_path)))
    file = sitting.base.configuration_file("mine")
    file.write_text(file.read_text().replace("RMODFILE    a", "RMODFILE    stranger"))
    sitting.do(act.Close(doc))
    doc = sitting.do(act.Open(path))
    document = sitting.environment.tree.documents[doc]
    assert document.tasks["stranger"].is_missing
