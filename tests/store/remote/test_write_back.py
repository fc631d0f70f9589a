import pytest

from kit.labs.kept_library import KeptLibrary
from kit.labs.library_site import taken, wink
from onika.store.remote.own_changes import OwnChange, named_changes, own_changes
from onika.store.remote.write_back import Sent, Unsent, WriteBack
from onika.wire.library_change import ChangeTaken

RMOD = "module/wink.rmod"


class Writer:
    """A user of a kept library, who has copies of his own."""

    def __init__(self, folder, kept):
        self.kept = kept
        self.libraries = taken(folder, kept.site, kept.server.address)
        self.base = self.libraries.lock.base
        self.says, self.former = True, []

    @property
    def library(self):
        return self.libraries.find("wings")

    @property
    def checkout(self):
        return self.libraries.checkout(self.library)

    def write(self, path, text):
        (self.base / path).parent.mkdir(parents=True, exist_ok=True)
        (self.base / path).write_text(text)

    def text(self, path=RMOD):
        return (self.base / path).read_text()

    def send(self, *paths, agrees=True, mine_counts=False):
        changes = named_changes(self.checkout, paths) if paths else own_changes(self.checkout)
        assert isinstance(changes, tuple), changes
        writing = WriteBack(self.libraries, self.library, lambda *_: agrees, lambda *kept: self.former.append(kept))
        return writing.send(changes, self.kept.today, "a note", mine_counts=mine_counts)

    def update(self):
        renewal = self.libraries.renewal(self.library, self.kept.today)
        self.libraries.renew(self.library, renewal)


@pytest.fixture
def kept(tmp_path):
    with KeptLibrary(tmp_path) as kept:
        yield kept


@pytest.fixture
def ann(tmp_path, kept):
    user = Writer(tmp_path / "ann", kept)
    yield user
    user.libraries.access.close()


@pytest.fixture
def bob(tmp_path, kept):
    user = Writer(tmp_path / "bob", kept)
    yield user
    user.libraries.access.close()


def test_an_own_copy_is_written_back_and_others_see_what_is_new(ann, bob):  # R-F03
    ann.write(RMOD, wink(says="blinks"))
    assert ann.send() == Sent(2, (RMOD,))
    assert ann.kept.text(RMOD) == wink(says="blinks") and ann.library.version == 2
    assert own_changes(ann.checkout) == ()
    assert bob.libraries.renewal(bob.library, bob.kept.today).changes.altered == (RMOD,)


def test_a_new_file_is_sent_when_it_is_named(ann):  # R-F03
    ann.write("module/new.rmod", wink(says="new"))
    assert own_changes(ann.checkout) == ()
    assert ann.send("module/new.rmod").version == 2
    assert ann.kept.text("module/new.rmod") == wink(says="new")


def test_changes_of_two_are_merged_and_sent_when_they_were_seen(ann, bob):  # R-F03
    ann.write(RMOD, wink(says="blinks"))
    bob.write(RMOD, wink().replace("50", "60"))
    ann.send()
    held = bob.send(agrees=False)
    assert isinstance(held, Unsent) and held.merged == (RMOD,) and held.contradicting == ()
    both = wink(says="blinks").replace("50", "60")
    assert (held.folder / f"{RMOD}.merged").read_text() == both
    assert bob.text() == wink().replace("50", "60") and bob.kept.text(RMOD) == wink(says="blinks")
    assert bob.send() == Sent(3, (RMOD,), (RMOD,))
    assert bob.kept.text(RMOD) == bob.text() == both
    assert bob.former == [(bob.base / RMOD, wink().replace("50", "60"))]


def test_what_contradicts_is_kept_and_named_and_nothing_is_sent(ann, bob):  # R-F03
    ann.write(RMOD, wink(says="blinks"))
    bob.write(RMOD, wink(says="glows"))
    bob.write("module/new.rmod", wink(says="new"))
    ann.send()
    held = bob.send(RMOD, "module/new.rmod")
    assert isinstance(held, Unsent) and held.contradicting == (RMOD,)
    versions = {name: (held.folder / f"{RMOD}.{name}").read_text() for name in ("mine", "theirs", "before", "both")}
    assert versions["mine"] == bob.text() == wink(says="glows")
    assert versions["theirs"] == bob.kept.text(RMOD) == wink(says="blinks") and versions["before"] == wink()
    assert versions["both"].count("<<<<<<<") == 1
    assert not (bob.kept.site.base / "module/new.rmod").exists()
    assert bob.send(RMOD, mine_counts=True) == Sent(3, (RMOD,))
    assert bob.kept.text(RMOD) == wink(says="glows")


def test_what_was_begun_with_an_older_version_is_merged_also_after_an_update(ann, bob):  # R-F03
    bob.write(RMOD, wink().replace("50", "60"))
    ann.write(RMOD, wink(says="blinks"))
    ann.send()
    bob.update()
    assert bob.library.version == 2 and list(bob.library.bases) == [RMOD]
    assert own_changes(bob.checkout)[0].before == wink().encode()
    assert bob.send().merged == (RMOD,)
    assert bob.kept.text(RMOD) == wink(says="blinks").replace("50", "60")
    assert bob.library.bases == {}


def test_what_was_removed_or_altered_at_the_site_and_not_published_is_not_written_over(ann):  # R-F03
    ann.write(RMOD, wink(says="blinks"))
    ann.kept.site.write(RMOD, wink(says="their draft"))
    held = ann.send()
    assert isinstance(held, Unsent) and held.contradicting == (RMOD,)
    assert (held.folder / f"{RMOD}.theirs").read_text() == wink(says="their draft")
    assert ann.kept.text(RMOD) == wink(says="their draft")


def test_somebody_who_sends_between_looking_and_sending_is_not_written_over(ann):  # R-F03
    ann.write(RMOD, wink(says="blinks"))
    kept, first = ann.kept, True

    def crossed(body):
        nonlocal first
        if first:
            first = False
            assert isinstance(kept.change((RMOD, wink(), wink().replace("50", "70")), user="kim"), ChangeTaken)
        return kept.taken(body)

    kept.server.takes = crossed
    assert ann.send() == Sent(3, (RMOD,), (RMOD,))
    assert kept.text(RMOD) == wink(says="blinks").replace("50", "70")


def test_the_same_change_of_two_is_no_change_any_more(ann, bob):  # R-F03
    for user in (ann, bob):
        user.write(RMOD, wink(says="blinks"))
    ann.send()
    assert bob.send() == Sent(2, ())
    assert own_changes(bob.checkout) == ()


def test_a_server_that_only_gives_takes_nothing(ann):  # R-F03
    ann.write(RMOD, wink(says="blinks"))
    ann.kept.server.takes = None
    assert ann.send().key == "store.takes_no_changes"
    ann.kept.server.takes = lambda _body: b"{}"
    assert ann.send().key == "store.no_change_answer"


def test_what_the_site_refuses_is_told_and_stays_here(ann):  # R-F03
    ann.write(RMOD, "MODULE nothing")
    assert ann.send().key == "site.file_at_fault"
    assert ann.text() == "MODULE nothing" and isinstance(own_changes(ann.checkout)[0], OwnChange)
