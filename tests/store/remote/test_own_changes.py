from dataclasses import replace
from hashlib import sha256

import pytest

from kit.labs.library_site import TODAY, LibrarySite, taken, wink
from onika.store.remote.own_changes import OwnChange, named_changes, own_changes

RMOD = "module/wink.rmod"


@pytest.fixture
def libraries(tmp_path):
    site = LibrarySite(tmp_path)
    site.publish()
    return taken(tmp_path, site)


@pytest.fixture
def checkout(libraries):
    (libraries.lock.base / "module").mkdir()
    return libraries.checkout(libraries.find("wings"))


def test_own_copies_that_say_something_else_are_changes(checkout):  # R-F03
    own = checkout.base / RMOD
    own.write_text(wink())
    assert own_changes(checkout) == ()
    own.write_text(wink(says="blinks"))
    base = sha256(wink().encode()).hexdigest()
    assert own_changes(checkout) == (OwnChange(RMOD, base, wink(says="blinks").encode(), wink().encode()),)


@pytest.mark.parametrize(
    ("path", "why"),
    [
        ("../secret", "files.index_path"),
        ("prefs/buttons", "files.index_path"),
        ("module/none.rmod", "store.no_own_file"),
        ("module/wink.rmod", "store.own_unchanged"),
    ],
)
def test_what_is_no_change_is_not_sent(checkout, path, why):  # R-F03
    (checkout.base / RMOD).write_text(wink())
    assert named_changes(checkout, [path]).key == why


def test_a_new_file_is_begun_with_nothing(checkout):  # R-F03
    (checkout.base / "module/new.rmod").write_text(wink())
    (change,) = named_changes(checkout, ["module/new.rmod", "module/new.rmod"])
    assert (change.base, change.before) == ("", None)


def test_with_what_a_copy_was_begun_is_remembered_when_the_library_goes_on(tmp_path, libraries):  # R-F03
    (libraries.lock.base / RMOD).parent.mkdir()
    (libraries.lock.base / RMOD).write_text(wink(says="blinks"))
    site = LibrarySite.__new__(LibrarySite)
    site.name, site.base, site.folder, site.key = (
        "wings",
        *(tmp_path / name for name in ("wings", "wings_public", "wings_key")),
    )
    for says in ("glows", "shines"):
        site.write(RMOD, wink(says=says))
        site.publish()
        library = libraries.find("wings")
        libraries.renew(library, libraries.renewal(library, TODAY))
    checkout = libraries.checkout(libraries.find("wings"))
    assert checkout.locked.bases == {RMOD: sha256(wink().encode()).hexdigest()}
    assert own_changes(checkout)[0].before == wink().encode()
    assert own_changes(replace(checkout, locked=replace(checkout.locked, bases={})))[0].before != wink().encode()
