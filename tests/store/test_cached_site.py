import os

from kit.labs.laboratory import Laboratory, job
from onika.store.cached_site import RememberingSite
from onika.store.site import open_site


def test_a_file_is_read_again_only_when_it_has_changed(tmp_path):
    files = Laboratory(tmp_path)
    files.plain_task("a", writes="A")
    path = files.configuration("aC", "a 100")
    files.application("play", [job("aC")])
    site = RememberingSite.of(open_site([tmp_path], {}, None))
    syntax, _ = site.syntax()

    def read():
        return site.task("a"), site.configuration("aC"), site.application("play", syntax)

    first, again = read(), read()
    assert all(item is other for item, other in zip(first, again, strict=True))
    files.configuration("aC", "a 50")
    os.utime(path, ns=(1, 1))
    assert site.configuration("aC")[0].placed[0].frequency == 50.0
    path.unlink()
    assert site.configuration("aC") == (None, ())


def test_with_another_directory_first_it_still_remembers(tmp_path):
    Laboratory(tmp_path / "own").configuration("aC", "a 100")
    Laboratory(tmp_path / "other").configuration("bC", "b 100")
    site = RememberingSite.of(open_site([tmp_path / "other"], {}, None))
    configuration = site.configuration("bC")
    own = site.at(tmp_path / "own")
    assert own.configuration("bC") is configuration and own.configuration("aC")[0] is not None
    assert site.configuration("aC")[0] is None


def test_stamps_tell_what_has_changed(tmp_path):
    path = Laboratory(tmp_path).configuration("aC", "a 100")
    site = RememberingSite.of(open_site([tmp_path], {}, None))
    before = site.stamps((path, None, tmp_path / "none"))
    assert before[1:] == (None, None) and before[0] is not None
    os.utime(path, ns=(1, 1))
    assert site.stamps((path,)) != before[:1]
