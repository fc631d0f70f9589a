import threading

import pytest

from kit.labs.kept_library import MINUTE_NS, KeptLibrary
from kit.labs.library_site import TODAY, WINK_CODE, libraries_of, new_key, wink
from onika.agent.library_keeper import MOST_BYTES, MOST_CHANGES
from onika.files.library_index import LibraryIndex
from onika.link.caller import Role
from onika.store.remote.publication import fingerprint_of
from onika.store.remote.remote_libraries import Offer
from onika.wire.library_change import ChangedMeanwhile, ChangeRefused, ChangeTaken, PresentFile

RMOD = "module/wink.rmod"


@pytest.fixture
def kept(tmp_path):
    with KeptLibrary(tmp_path) as kept:
        yield kept


def lines(kept):
    kept.trail.close()
    text = kept.trail.path.read_text()
    kept.trail = kept.keeper._trail = type(kept.trail)(kept.trail.path)
    return text


def test_a_changed_file_is_taken_and_published_anew(kept, tmp_path):  # R-F03
    assert kept.change((RMOD, wink(), wink(says="blinks"))) == ChangeTaken("wings", 2)
    assert kept.text(RMOD) == wink(says="blinks")
    offer = libraries_of(tmp_path).offer(str(kept.site.folder), kept.today)
    assert isinstance(offer, Offer) and offer.index.version == 2
    assert offer.index.files[RMOD].content == wink(says="blinks").encode()
    said = lines(kept)
    assert '"ChangeLibrary"' in said and "lamp off" in said and RMOD in said and "ann" in said


def test_what_somebody_else_has_changed_meanwhile_is_never_written_over(kept):  # R-F03
    assert isinstance(kept.change((RMOD, wink(), wink(says="blinks"))), ChangeTaken)
    answer = kept.change((RMOD, wink(), wink(says="glows")), ("module/new.rmod", None, wink(says="new")), user="bob")
    assert answer == ChangedMeanwhile((PresentFile(RMOD, wink(says="blinks").encode()),))
    assert kept.text(RMOD) == wink(says="blinks") and not (kept.site.base / "module/new.rmod").exists()
    assert f'"behind {RMOD}"' in lines(kept)


def test_of_many_who_change_one_version_at_a_time_one_is_taken(kept):  # R-F03
    answers = []
    threads = [
        threading.Thread(target=lambda n=n: answers.append(kept.change((RMOD, wink(), wink(says=f"by {n}")))))
        for n in range(8)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(type(answer).__name__ for answer in answers) == ["ChangeTaken"] + ["ChangedMeanwhile"] * 7


@pytest.mark.parametrize(
    ("path", "content", "why"),
    [
        ("../wink.rmod", wink(), "files.index_path"),
        ("module/.hidden.rmod", wink(), "files.index_path"),
        ("prefs/buttons", "x", "files.index_path"),
        ("module/x.exe", "x", "files.index_path"),
        ("module/x.rmod", "MODULE", "site.file_at_fault"),
        ("module/x.py", "def x(:", "site.file_at_fault"),
        ("module/x.py", b"\xff\xfe", "site.file_no_text"),
        ("conf/x.conf", "VERSION 9.9\n", "site.file_at_fault"),
        ("appl/x.appl", "nothing", "site.file_at_fault"),
        ("robot/x.bin", b"x" * (MOST_BYTES + 1), "site.change_large"),
    ],
)
def test_what_is_no_file_of_a_library_is_refused(kept, path, content, why):  # R-F03
    answer = kept.change((path, None, content))
    assert isinstance(answer, ChangeRefused) and answer.reason.key == why
    assert kept.publisher.former().version == 1


def test_who_may_not_bring_code_changes_nothing(kept):  # R-F03
    for role in (Role.VIEWER, Role.OPERATOR):
        answer = kept.change((RMOD, wink(), wink(says="glows")), role=role)
        assert answer.reason.key == "site.programmer_wanted"
    assert kept.text(RMOD) == wink() and '"refused:' in lines(kept)


def test_a_link_leads_nobody_out_of_the_library(kept, tmp_path):  # R-F03
    (tmp_path / "secret").mkdir()
    (kept.site.base / "robot").symlink_to(tmp_path / "secret")
    (kept.site.base / "module/far.py").symlink_to(tmp_path / "secret/far.py")
    for path in ("robot/x.bin", "module/far.py"):
        assert kept.change((path, None, "x = 1")).reason.key == "site.file_elsewhere"
    assert not list((tmp_path / "secret").iterdir())


def test_too_many_changes_within_a_minute_wait(kept):  # R-F03
    for _ in range(MOST_CHANGES):
        kept.change((RMOD, "other", wink()))
    assert kept.change((RMOD, "other", wink())).reason.key == "site.changes_too_fast"
    assert isinstance(kept.change((RMOD, "other", wink()), user="bob"), ChangedMeanwhile)
    kept.now_ns += MINUTE_NS
    assert isinstance(kept.change((RMOD, "other", wink())), ChangedMeanwhile)


def test_what_cannot_be_published_is_not_changed(kept):  # R-F03
    kept.site.key.unlink()
    kept.site.key.with_suffix(".pub").unlink()
    files = ((RMOD, wink(), wink(says="glows")), ("module/new.rmod", None, wink()))
    assert kept.change(*files).reason.key == "site.library_not_published"
    assert kept.text(RMOD) == wink() and not (kept.site.base / "module/new.rmod").exists()


def test_what_its_owner_has_changed_is_published_when_it_is_served_again(kept):  # R-F03
    assert kept.keeper.begin() is None
    kept.site.write("module/wink.py", WINK_CODE + "\n# more\n")
    assert kept.keeper.begin().index.version == 2
    former = kept.publisher.former()
    assert isinstance(former, LibraryIndex) and "module/wink.py" in former.files


def test_a_site_whose_key_has_changed_signs_its_library_anew(kept, tmp_path):  # R-F03, R-X16
    young = new_key(tmp_path, "young")
    kept.publisher.publish(TODAY, next_key=fingerprint_of(young.with_suffix(".pub")))
    assert kept.keeper.begin() is None
    for path in (young, young.with_suffix(".pub")):
        path.replace(kept.site.key.with_suffix(path.suffix))
    published = kept.keeper.begin()
    assert published.signer == fingerprint_of(kept.site.key.with_suffix(".pub"))
    assert published.index.next_key == ""
    assert kept.keeper.begin() is None
