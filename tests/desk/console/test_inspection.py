from onika.desk.console.display import Tone
from onika.wire import live


def test_status_shows_the_columns_that_the_user_prefers(sit, tmp_path):  # R-A11
    one = sit()
    one.does("spawn puma diff")
    head, *rows = one.does("status")
    assert head.split() == ["task", "rmod", "rtpu", "state", "cycle", "miss", "ref-F/Hz", "mez-F/Hz", "avg-U/%", "warn"]
    assert rows[0].split() == ["puma", "puma", "rt0", "off", "10", "0", "500.0", "500.0", "20.0", "0"]
    assert rows[-1] == "load: rt0 25.0%  rt1 25.0%"


def test_status_of_a_task_shows_every_figure(sit):  # R-A11
    one = sit()
    one.does("spawn puma")
    said = one.does("status puma")
    assert said[0] == "main/puma"
    assert [line.split()[0] for line in said[1:-1]] == list(_COLUMNS)
    assert one.fails("status diff").expected == "a living task of main (puma)"


def test_an_overload_that_is_foretold_is_told(sit, monkeypatch):  # R-X13
    one = sit()
    figures = live.Figures((), {"rt0": 0.95}, ("rt0 will have 1.2 s of work in a second",))
    monkeypatch.setattr(one.runtime, "_look", lambda asked: figures)
    assert one.does("status")[-1] == "rt0 will have 1.2 s of work in a second"
    assert one.tones[-1] is Tone.FAULT


def test_the_living_tasks_are_listed_by_subsystem(sit):  # R-A06
    one = sit()
    assert one.does("tasks")[0].startswith("no task lives here")
    one.does("spawn puma", "spawn left/diff")
    said = one.does("tasks")
    assert [line.split()[:3] for line in said[1:]] == [["main/puma", "OFF", "rt0"], ["left/diff", "OFF", "rt0"]]
    assert len(one.does("tasks left")) == 2


def test_the_library_says_what_there_is_to_use(sit):
    one = sit()
    said = one.does("library j*")
    jobs = ["jmoveC", "jmove_rightC", "jmove_scaraC", "jmove_viaC"]
    assert [line.split()[0] for line in said] == ["name", "jtraj", "jvia", *jobs]
    assert "joint path of fifth order" in said[1]
    assert one.does("library nothing") == ["nothing is called so"]


def test_a_task_file_with_faults_is_listed_as_such(sit, tmp_path):
    (tmp_path / "module").mkdir()
    (tmp_path / "module" / "bad.rmod").write_text("MODULE\n")
    assert "its file has faults" in sit().does("library bad")[1]


def test_units_and_subsystems_are_listed(sit):  # R-A06
    one = sit()
    assert [line.split() for line in one.does("rtpus")[1:]] == [["rt0", "alive", "25.0%"], ["rt1", "alive", "25.0%"]]
    assert one.does("subsystems")[1].split()[:4] == ["*", "main", "0", "nobody"]
    one.does("spawn left/puma", "take left", "subsystem left")
    assert one.does("subsystems")[1].split()[:4] == ["*", "left", "1", "you"]
    assert one.does("subsystem") == ["left"]
    assert one.fails("subsystem 7").found == "'7'"


def with_variables(one):
    one.does("spawn puma")
    one.runtime.variables["main"] = {
        "NDOF": 2,
        "Q_MEZ": [0.5, -0.25],
        "BASE": [[1.0, 0.0], [0.0, 1.0]],
        "ROBOT": "PUMA 560",
    }
    return one


def test_variables_are_listed_with_their_types(sit):  # R-A03
    one = with_variables(sit())
    rows = {line.split()[0]: line.split()[1:] for line in one.does("vars")[1:]}
    assert rows["NDOF"] == ["int", "2"]
    assert rows["Q_MEZ"] == ["double[2]", "0.5000", "-0.2500"]
    assert rows["BASE"][0] == "double[2,2]"
    assert rows["BASE"][-1] == "…"
    assert rows["ROBOT"] == ["string", "'PUMA", "560'"]
    assert [line.split()[0] for line in one.does("vars Q*")[1:]] == ["Q_MEZ"]
    assert one.does("vars Z*") == ["main has no such variable"]


def test_a_vector_is_read_in_a_line_and_a_matrix_in_rows(sit):  # R-A16
    one = with_variables(sit())
    assert one.does("read Q_MEZ main/NDOF") == ["Q_MEZ = 0.5000  -0.2500", "main/NDOF = 2"]
    assert one.does("read BASE") == ["BASE[0] = 1.0000  0.0000", "BASE[1] = 0.0000  1.0000"]
    assert one.does("read Q_MEZ[1] BASE[1,1] BASE[0]") == [
        "Q_MEZ[1] = -0.2500",
        "BASE[1,1] = 1.0000",
        "BASE[0] = 1.0000  0.0000",
    ]
    for line in ("read Q_MEZ[2]", "read NDOF[0]", "read BASE[0,0,0]"):
        assert one.fails(line).expected == "an element, counted from 0"
    assert one.fails("read NDOF Q_MES").found == "'Q_MES'"
    assert "no subsystem other" in one.fails("read other/Q").found


def test_a_check_of_memory_names_what_it_finds(sit):  # R-A12
    one = with_variables(sit())
    assert one.does("check") == ["main: the memory of variables is sound"]
    one.runtime.findings["main"] = ("Q_MEZ was overwritten; puma on rt0 writes beside it",)
    fault = one.fails("check main")
    assert fault.found == "Q_MEZ was overwritten; puma on rt0 writes beside it"


def test_what_the_runtime_will_not_say_is_a_fault(sit):
    one = sit()
    one.runtime.refusals |= {"Status": "not now", "Check": "not now", "Read": "not now"}
    one.does("spawn puma")
    for line in ("status", "check", "vars", "read Q"):
        assert one.fails(line).found == "not now"


_COLUMNS = (
    "rmod", "rtpu", "tid", "S", "crit", "state", "cycle", "miss", "ref-F", "ref-T", "mez-F", "mez-T", "ptime", "tot-C",
    "tick", "min-U", "max-U", "avg-U", "min-C", "max-C", "avg-C", "warn",
)  # fmt: skip
