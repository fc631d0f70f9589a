from onika.desk.console.display import Tone
from onika.wire import live
from onika.words.reason import Reason


def test_status_shows_the_columns_that_the_user_prefers(sit, tmp_path):  # R-A11
    sitting = sit()
    sitting.does("spawn puma diff")
    head, *rows = sitting.does("status")
    assert head.split() == ["task", "rmod", "rtpu", "state", "cycle", "miss", "ref-F/Hz", "mez-F/Hz", "avg-U/%", "warn"]
    assert rows[0].split() == ["puma", "arm", "rt0", "off", "10", "0", "500.0", "500.0", "20.0", "0"]
    assert rows[-1] == "load: rt0 25.0%  rt1 25.0%"


def test_status_of_a_task_shows_every_figure(sit):  # R-A11
    sitting = sit()
    sitting.does("spawn puma")
    output = sitting.does("status puma")
    assert output[0] == "main/puma"
    assert [line.split()[0] for line in output[1:-1]] == list(_COLUMNS)
    assert sitting.fails("status diff").reason == Reason.of(
        "console.not_living", subsystem="main", living=("puma",), name="diff"
    )


def test_an_overload_that_is_foretold_is_told(sit, monkeypatch):  # R-X13
    sitting = sit()
    figures = live.Figures((), {"rt0": 0.95}, (Reason.plain("rt0 will have 1.2 s of work in a second"),))
    look = sitting.runtime._look
    monkeypatch.setattr(sitting.runtime, "_look", lambda asked: figures if asked == live.Status() else look(asked))
    assert sitting.does("status")[-1] == "rt0 will have 1.2 s of work in a second"
    assert sitting.tones[-1] is Tone.FAULT


def test_status_says_who_drives_which_world_where_one_is_real(sit):  # R-E09, R-A11
    sitting = sit()
    sitting.does("spawn puma")
    sitting.runtime.worlds = {"boxes": True}
    assert not any("drives" in line for line in sitting.does("status"))
    sitting.runtime.worlds = {"boxes": False}
    assert sitting.does("status")[-1] == "main drives boxes (real)"


def test_the_living_tasks_are_listed_by_subsystem(sit):  # R-A06
    sitting = sit()
    assert sitting.does("tasks")[0].startswith("no task lives here")
    sitting.does("spawn puma", "spawn left/diff")
    output = sitting.does("tasks")
    assert [line.split()[:3] for line in output[1:]] == [["main/puma", "OFF", "rt0"], ["left/diff", "OFF", "rt0"]]
    assert len(sitting.does("tasks left")) == 2


def test_the_library_says_what_there_is_to_use(sit):
    sitting = sit()
    output = sitting.does("library j[gmtv]*")
    jobs = [
        "jmoveC",
        "jmove_gantryC",
        "jmove_hillC",
        "jmove_kinC",
        "jmove_learntC",
        "jmove_modular3C",
        "jmove_modular4C",
        "jmove_modular5C",
        "jmove_motorC",
        "jmove_motor_leftC",
        "jmove_motor_rightC",
        "jmove_pidC",
        "jmove_rampC",
        "jmove_rightC",
        "jmove_scaraC",
        "jmove_smoothC",
        "jmove_viaC",
    ]
    assert [line.split()[0] for line in output] == ["name", "jgenerator", "jtraj", "jvia", *jobs]
    assert "joint path of fifth order" in output[2]
    assert sitting.does("library nothing") == ["nothing is called so"]


def test_a_task_file_with_faults_is_listed_as_such(sit, tmp_path):
    (tmp_path / "module").mkdir()
    (tmp_path / "module" / "bad.rmod").write_text("MODULE\n")
    assert "its file has faults" in sit().does("library bad")[1]


def test_units_and_subsystems_are_listed(sit):  # R-A06
    sitting = sit()
    assert [line.split() for line in sitting.does("rtpus")[1:]] == [
        ["rt0", "alive", "25.0%"],
        ["rt1", "alive", "25.0%"],
    ]
    assert sitting.does("subsystems")[1].split()[:4] == ["*", "main", "0", "nobody"]
    sitting.does("spawn left/puma", "take left", "subsystem left")
    assert sitting.does("subsystems")[1].split()[:4] == ["*", "left", "1", "you"]
    assert sitting.does("subsystem") == ["left"]
    assert sitting.fails("subsystem 7").reason == Reason.of("desk.icon_name", name="7")


def with_variables(sitting):
    sitting.does("spawn puma")
    sitting.runtime.variables["main"] = {
        "NDOF": 2,
        "Q_MEZ": [0.5, -0.25],
        "BASE": [[1.0, 0.0], [0.0, 1.0]],
        "ROBOT": "PUMA 560",
    }
    return sitting


def test_variables_are_listed_with_their_types(sit):  # R-A03
    sitting = with_variables(sit())
    rows = {line.split()[0]: line.split()[1:] for line in sitting.does("vars")[1:]}
    assert rows["NDOF"] == ["int", "2"]
    assert rows["Q_MEZ"] == ["double[2]", "0.5000", "-0.2500"]
    assert rows["BASE"][0] == "double[2,2]"
    assert rows["BASE"][-1] == "…"
    assert rows["ROBOT"] == ["string", "'PUMA", "560'"]
    assert [line.split()[0] for line in sitting.does("vars Q*")[1:]] == ["Q_MEZ"]
    assert sitting.does("vars Z*") == ["main has no such variable"]


def test_a_vector_is_read_in_a_line_and_a_matrix_in_rows(sit):  # R-A16
    sitting = with_variables(sit())
    assert sitting.does("read Q_MEZ main/NDOF") == ["Q_MEZ = 0.5000  -0.2500", "main/NDOF = 2"]
    assert sitting.does("read BASE") == ["BASE[0] = 1.0000  0.0000", "BASE[1] = 0.0000  1.0000"]
    assert sitting.does("read Q_MEZ[1] BASE[1,1] BASE[0]") == [
        "Q_MEZ[1] = -0.2500",
        "BASE[1,1] = 1.0000",
        "BASE[0] = 1.0000  0.0000",
    ]
    for name in ("Q_MEZ[2]", "NDOF[0]", "BASE[0,0,0]"):
        assert sitting.fails(f"read {name}").reason == Reason.of("console.no_element", name=name)
    assert sitting.fails("read NDOF Q_MES").reason == Reason.of("console.no_variable", subsystem="main", name="Q_MES")
    assert (
        str(sitting.fails("read other/Q").reason)
        == "expected the variable Q of other, found there is no subsystem other"
    )


def test_a_check_of_memory_names_what_it_finds(sit):  # R-A12
    sitting = with_variables(sit())
    assert sitting.does("check") == ["main: the memory of variables is sound"]
    sitting.runtime.findings["main"] = ("Q_MEZ was overwritten; puma on rt0 writes beside it",)
    fault = sitting.fails("check main")
    assert str(fault.reason) == (
        "expected sound memory of variables in main, found Q_MEZ was overwritten; puma on rt0 writes beside it"
    )


def test_what_the_runtime_will_not_say_is_a_fault(sit):
    sitting = sit()
    sitting.runtime.refusals |= {"Status": "not now", "Check": "not now", "Read": "not now"}
    sitting.does("spawn puma")
    for line in ("status", "check", "vars", "read Q"):
        assert str(sitting.fails(line).reason).endswith(", found not now")


_COLUMNS = (
    "rmod", "rtpu", "tid", "S", "crit", "state", "cycle", "miss", "ref-F", "ref-T", "mez-F", "mez-T", "ptime", "tot-C",
    "tick", "min-U", "max-U", "avg-U", "min-C", "max-C", "avg-C", "warn",
)  # fmt: skip
