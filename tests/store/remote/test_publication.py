import subprocess
from datetime import timedelta

import pytest

from kit.labs.library_site import TODAY, LibrarySite
from onika.store.remote.index_check import SignedIndex, opened
from onika.store.remote.publication import Publisher, fingerprint_of
from onika.store.shipped import shipped
from onika.words.reason import Reason


@pytest.fixture
def site(tmp_path) -> LibrarySite:
    return LibrarySite(tmp_path)


def test_small_texts_stand_in_the_index_and_code_by_what_it_holds(site):  # R-F03
    publication = site.publish(description="lamps")
    found = opened((site.folder / "library").read_bytes())
    assert isinstance(found, SignedIndex)
    assert found.index == publication.index and found.signer == publication.signer
    code = found.index.files["module/wink.py"]
    assert code.content is None
    assert (site.folder / "objects" / code.digest).read_bytes() == (site.base / "module/wink.py").read_bytes()
    assert (found.index.description, found.index.until) == ("lamps", TODAY + timedelta(days=92))


def test_every_publication_has_a_number_above_the_former_one_and_former_files_stay(site):  # R-X16
    first = site.publish()
    code = (site.folder / "objects" / first.index.files["module/wink.py"].digest).read_bytes()
    site.write("module/wink.py", "# new\n")
    assert site.publish().index.version == 2
    assert code in [path.read_bytes() for path in (site.folder / "objects").iterdir()]


def test_a_web_server_may_read_what_is_published(site):  # R-F03
    site.publish()
    assert all(path.stat().st_mode & 0o044 == 0o044 for path in (site.folder, *site.folder.rglob("*")))


def test_hidden_files_and_those_of_no_library_stay_at_home(site):  # R-X16
    site.write("module/.secret.py", "password")
    site.write("module/__pycache__/wink.py", "compiled")
    site.write("module/notes.txt", "notes")
    site.write("diary/today.txt", "dear diary")
    publication = site.publish()
    assert set(publication.index.files) == {"module/wink.py", "module/wink.rmod"}
    assert publication.left_out == ("module/notes.txt",)


def test_the_fingerprint_is_that_of_ssh_keygen(site):  # R-X16
    listed = subprocess.run(["ssh-keygen", "-lf", f"{site.key}.pub"], capture_output=True, text=True, check=True)
    assert site.publish().signer == listed.stdout.split()[1] == fingerprint_of(site.key.with_suffix(".pub"))


def test_what_cannot_be_published_is_said(site, tmp_path):  # R-B07
    def key(publisher: Publisher) -> str:
        done = publisher.publish(TODAY)
        assert isinstance(done, Reason)
        return done.key

    site.publish()
    assert key(Publisher(site.base, site.folder, site.key, "other")) == "store.former_other"
    assert key(Publisher(site.base, site.folder, site.key, "../x")) == "store.library_name"
    assert key(Publisher(site.base, tmp_path / "new", tmp_path / "no_key", "wings")) == "store.not_signed"
    assert key(Publisher(tmp_path / "nothing", tmp_path / "new", site.key, "wings")) == "store.nothing_to_publish"
    (site.folder / "library").write_text("something else")
    assert key(Publisher(site.base, site.folder, site.key, "wings")) == "store.former_unread"


def test_every_shipped_laboratory_can_be_published_whole(site, tmp_path):  # R-F03
    for base in sorted(path for path in shipped().iterdir() if (path / "module").is_dir()):
        done = Publisher(base, tmp_path / "labs" / base.name, site.key, base.name).publish(TODAY)
        assert not isinstance(done, Reason), done
        assert done.left_out == ()


@pytest.mark.parametrize("options", [["-t", "ed25519", "-N", ""], ["-t", "rsa", "-N", "locked"]])
def test_whose_key_it_is_stands_in_it_also_where_a_pass_phrase_locks_it(tmp_path, options):  # R-X16
    key = tmp_path / "key"
    subprocess.run(["ssh-keygen", "-q", "-f", str(key), *options], check=True)
    public = fingerprint_of(key.with_suffix(".pub"))
    assert Publisher(tmp_path, tmp_path, key, "lamps").signer == public
    assert Publisher(tmp_path, tmp_path, key.with_suffix(".pub"), "lamps").signer == public
    key.write_text("-----BEGIN NOTHING-----\nbm90aGluZw==\n-----END NOTHING-----\n")
    assert Publisher(tmp_path, tmp_path, key, "lamps").signer is None
