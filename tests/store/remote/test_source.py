import os

from onika.store.remote.source import FolderSource, Wanted, object_path
from onika.words.reason import Reason


def test_a_folder_gives_its_files(tmp_path):  # R-F03
    (tmp_path / "library").write_bytes(b"an index")
    assert FolderSource(tmp_path).fetch([Wanted("library", 8)]) == {"library": b"an index"}
    assert object_path("9f") == "objects/9f"


def test_more_than_is_wanted_is_not_read(tmp_path):  # R-X16
    (tmp_path / "library").write_bytes(b"an index")
    reason = FolderSource(tmp_path).fetch([Wanted("library", 7)])
    assert isinstance(reason, Reason) and reason.key == "store.answer_large"


def test_a_pipe_on_a_stick_is_not_waited_for(tmp_path):  # R-X16
    os.mkfifo(tmp_path / "library")
    assert isinstance(FolderSource(tmp_path).fetch([Wanted("library", 7)]), Reason)


def test_a_stick_that_was_pulled_is_told(tmp_path):  # R-F03
    reason = FolderSource(tmp_path / "gone").fetch([Wanted("library", 7)])
    assert isinstance(reason, Reason) and reason.key == "store.not_fetched"
