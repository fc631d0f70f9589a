import json

import pytest

from onika.desk.environment.replay.replay_place import made
from onika.files.state.session_log import LogLine
from onika.store.shipped import shipped


@pytest.fixture
def place(tmp_path):
    start = {
        "bases": [{"name": "lab", "files": {}}, {"name": "..", "files": {}}],
        "own_at": 1,
        "own": {"../x": "no", "onika": "no", "a\0b": "no", ".onika": "yes"},
    }
    line = LogLine(2, 0.0, "Start_Onika", "none", "0", "none", "0", "root", {"s": "a", "n": 0, "start": start})
    (tmp_path / "given" / "conf").mkdir(parents=True)
    (tmp_path / "given" / "conf" / "a.conf").write_text("x")
    return made([line], [tmp_path / "given"], tmp_path / "replay", "s.log")


def test_directories_are_copied_under_their_names_and_the_own_one_into_the_home(place, tmp_path):  # R-H08
    assert (tmp_path / "replay" / "base0" / "lab" / "conf" / "a.conf").read_text() == "x"
    assert place.site.own == tmp_path / "replay" / "home" / "onika"
    assert (tmp_path / "replay" / "home" / ".onika").read_text() == "yes" and not (tmp_path / "replay" / "x").exists()
    assert place.here({"path": "{base0}/conf/a.conf", "own": "~/x"}) == {
        "path": str(tmp_path / "replay/base0/lab/conf/a.conf"),
        "own": str(tmp_path / "replay/home/x"),
    }
    assert [fault.reason.key for fault in place.faults] == ["replay.file_new"]


def test_paths_elsewhere_are_strange_and_texts_are_none(place, tmp_path):  # R-H08
    inside = str(tmp_path / "replay" / "base0" / "lab" / "conf")
    for value in (inside, str(shipped() / "boxes" / "appl"), "assemble", "ws://robot:1"):
        assert place.strange_path({"doc": "a1", "flow": "1/17/0", "path": value}) == ""
    for value in ("/etc/passwd", "../../x", f"{inside}/../../../../x", "~/x", "file:///etc", "x/../../y"):
        assert place.strange_path({"more": [{"base": value}]}) == value
    assert place.strange_path({"text": "/etc", "description": "../"}) == ""


def test_a_link_that_leads_out_is_not_followed(place, tmp_path):  # R-H08
    (tmp_path / "replay" / "base0" / "out").symlink_to(tmp_path)
    assert place.strange_path({"base": str(tmp_path / "replay" / "base0" / "out" / "x")})
    assert json.dumps(place.here({"a": '"~/quoted'}))
