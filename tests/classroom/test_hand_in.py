import os

from kit.desk.app_fixture import AppFixture
from onika.classroom import hand_in


def put(path, text="x"):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def files(folder):
    return {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*") if path.is_file()}


def test_plain_files_are_taken_over_and_a_link_leads_nowhere(tmp_path):  # R-X25
    own, secret = tmp_path / "own", tmp_path / "secret"
    put(own / "appl" / "a.appl")
    put(own / ".hidden" / "b")
    put(secret / "key", "private")
    (own / "appl" / "link.appl").symlink_to(secret / "key")
    (own / "conf").symlink_to(secret)
    os.mkfifo(own / "pipe")
    assert not hand_in.taken_over(own, tmp_path / "copy")
    assert files(tmp_path / "copy") == {"appl/a.appl": "x"}


def test_more_than_fits_is_told_and_left_out(tmp_path, monkeypatch):
    monkeypatch.setattr(hand_in, "MOST_BYTES", 3)
    for name in "abcde":
        put(tmp_path / "own" / name)
    assert hand_in.taken_over(tmp_path / "own", tmp_path / "copy").key == "class.hand_in_large"
    assert len(files(tmp_path / "copy")) == 3


def test_what_is_open_is_handed_in_also_where_it_is_not_saved(tmp_path):  # R-X25
    desk = AppFixture(tmp_path / "base")
    desk.begun("move", "there")
    texts = hand_in.open_texts(desk.environment.model)
    ((name, content),) = texts.items()
    assert name.startswith("appl/")
    assert "there" in content
    own = tmp_path / "mine"
    put(own / "appl" / "old.appl", "old")
    hand_in.put_together(own, texts, tmp_path / "made")
    assert files(tmp_path / "made") == {"appl/old.appl": "old", **texts}
