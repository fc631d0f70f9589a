import pytest


@pytest.fixture
def sitting(sit):
    sitting = sit()
    sitting.does("spawn puma pd", "spawn left/diff")
    sitting.runtime.variables["main"] = {"Q_MEZ": [0.0], "Q_REF": [0.0], "NDOF": 6}
    return sitting


@pytest.mark.parametrize(
    ("before", "expected"),
    [
        ("", None),
        ("sp", ["spawn"]),
        ("on ", ["left/diff", "pd", "puma"]),
        ("on p", ["pd", "puma"]),
        ("kill puma p", ["pd", "puma"]),
        ("spawn jt", ["jtraj"]),
        ("spawn jtraj on rt", ["rt0", "rt1"]),
        ("config jmove_r", ["jmove_rampC", "jmove_rightC"]),
        ("on pd @hom", ["@home"]),
        ("run go", ["go_home"]),
        ("read Q_", ["Q_MEZ", "Q_REF"]),
        ("read left/Q", []),
        ("subsystem l", ["left"]),
        ("help sw", ["swap", "switch"]),
        ("wait puma o", ["off", "on"]),
        ("quit ", ["runtime"]),
        ("echo x", []),
        ("s x", []),
        ("dance x", []),
    ],
)
def test_what_may_stand_at_the_cursor_is_offered(sitting, before, expected):  # R-A16
    candidates = sitting.console.completion.candidates(before)
    if expected is None:
        assert {"spawn", "quit", "help"} <= set(candidates)
    else:
        assert candidates == expected


def test_a_task_that_asks_is_offered_for_an_answer(asking):
    asking.does("spawn jtraj diff", "on jtraj")
    assert asking.console.completion.candidates("answer ") == ["jtraj"]


def test_files_and_folders_are_offered_for_scripts(sitting, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scripts").mkdir()
    (tmp_path / "scripts" / "start").write_text("")
    (tmp_path / ".hidden").write_text("")
    offer = sitting.console.completion.candidates
    assert offer("source ") == ["scripts/"]
    assert offer("source scripts/") == ["scripts/start"]
    assert offer("<scr") == ["<scripts/"]
    assert offer("source nowhere/x") == []
    assert offer("source .h") == [".hidden"]
