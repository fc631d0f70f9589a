import os
import stat
from pathlib import Path

import pytest

from onika.files.state.access import ANYTHING, STRANGERS, WRITING, Access, AccessReport, guard
from onika.words.reason import Reason


def made(path, mode):
    path.write_text("secret")
    path.chmod(mode)
    return path


def mode(path):
    return stat.S_IMODE(path.stat().st_mode)


@pytest.mark.parametrize(
    ("before", "denied", "after"),
    [
        (0o666, ANYTHING, 0o600),
        (0o640, ANYTHING, 0o600),
        (0o666, WRITING, 0o644),
        (0o664, WRITING, 0o644),
        (0o644, STRANGERS, 0o640),
    ],
)
def test_rights_that_others_may_not_have_are_taken_back_and_told(tmp_path, before, denied, after):  # R-X12
    path = made(tmp_path / "token", before)
    report = guard([Access(path, denied)])
    assert (mode(path), report.mended, report.refused) == (after, (path,), ())
    assert report.sentences == (Reason.of("files.access_mended", paths=(str(path),)),)
    assert guard([Access(path, denied)]) == AccessReport()


@pytest.mark.parametrize(("right", "denied"), [(0o600, ANYTHING), (0o644, WRITING), (0o640, STRANGERS)])
def test_what_is_as_it_should_be_stays_so_without_a_word(tmp_path, right, denied):
    path = made(tmp_path / "users", right)
    assert guard([Access(path, denied)]).sentences == ()
    assert mode(path) == right


def test_a_folder_is_closed_too_and_stays_a_folder_of_ours(tmp_path):
    folder = tmp_path / "state"
    folder.mkdir()
    folder.chmod(0o777)
    assert guard([Access(folder, ANYTHING)]).mended == (folder,)
    assert mode(folder) == 0o700


def test_what_belongs_to_another_is_refused_and_left_as_it_is(tmp_path):  # R-X12
    path = made(tmp_path / "token", 0o600)
    report = guard([Access(path, ANYTHING)], user=os.geteuid() + 12345)
    if os.geteuid() == 0:  # the superuser's own files are nobody's back door
        assert report == AccessReport()
        os.chown(path, 4321, -1)
        report = guard([Access(path, ANYTHING)], user=1234)
    (reason,) = report.refused
    assert (reason.key, report.mended) == ("files.access_of_another", ())
    assert mode(path) == 0o600


def test_a_disk_that_keeps_no_rights_is_refused(tmp_path, monkeypatch):
    path = made(tmp_path / "token", 0o644)
    monkeypatch.setattr(Path, "chmod", lambda *_: None)
    why = Reason.of("files.access_not_kept")
    expected = Reason.of("files.access_open", path=str(path), rights="077", why=why)
    assert guard([Access(path, ANYTHING)]).refused == (expected,)


def test_a_disk_that_can_only_be_read_is_refused_with_its_reason(tmp_path, monkeypatch):
    def chmod(*_):
        raise OSError(30, "Read-only file system")

    path = made(tmp_path / "token", 0o644)
    monkeypatch.setattr(Path, "chmod", chmod)
    (reason,) = guard([Access(path, ANYTHING)]).refused
    assert reason.args["why"].key == "words.disk_read_only"


def test_what_is_not_there_or_is_no_file_is_left_to_whoever_opens_it(tmp_path):
    (tmp_path / "file").write_text("")
    nothing = [tmp_path / "none", tmp_path / "file" / "below", Path("/dev/null")]
    assert guard(Access(path, ANYTHING) for path in nothing) == AccessReport()


def test_of_many_that_are_mended_a_few_are_named(tmp_path):
    paths = [made(tmp_path / f"{number}.log", 0o644) for number in range(6)]
    (sentence,) = guard(Access(path, ANYTHING) for path in paths).sentences
    assert (sentence.key, sentence.args["more"], len(sentence.args["paths"])) == ("files.access_mended_more", 2, 4)
