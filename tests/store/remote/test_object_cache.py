from hashlib import sha256
from pathlib import Path

import pytest

from onika.store.remote.object_cache import ObjectCache, cache_directory, write_whole

DIGEST = sha256(b"content").hexdigest()


def test_what_is_kept_is_found_by_what_it_holds(tmp_path):  # R-F03
    cache = ObjectCache(tmp_path)
    assert cache.get(DIGEST) is None
    assert cache.put(b"content") == DIGEST
    assert cache.get(DIGEST) == b"content"


def test_what_was_altered_is_as_if_it_were_not_there_and_is_kept_anew(tmp_path):  # R-X16
    cache = ObjectCache(tmp_path)
    cache.put(b"content")
    file = next(path for path in tmp_path.rglob("*") if path.is_file())
    file.write_bytes(b"c0ntent")
    assert cache.get(DIGEST) is None and cache.is_altered(DIGEST)
    cache.put(b"content")
    assert cache.get(DIGEST) == b"content" and not cache.is_altered(DIGEST)


def test_many_things_are_kept_at_once(tmp_path):  # R-F03
    cache = ObjectCache(tmp_path)
    cache.put_all([b"content", b"other", b"content"])
    assert cache.get(DIGEST) == b"content" and cache.get(sha256(b"other").hexdigest()) == b"other"
    assert len([path for path in tmp_path.rglob("*") if path.is_file()]) == 2


def test_the_cache_is_its_users_only(tmp_path):  # R-X16
    cache = ObjectCache(tmp_path / "cache")
    cache.put(b"content")
    assert (tmp_path / "cache").stat().st_mode & 0o077 == 0


def test_a_file_that_cannot_be_written_leaves_nothing_behind(tmp_path):  # R-F03
    (tmp_path / "here").mkdir()
    with pytest.raises(OSError):
        write_whole(tmp_path / "here", b"content")
    assert list(tmp_path.iterdir()) == [tmp_path / "here"]


def test_it_lies_where_the_system_keeps_caches():  # R-F03
    assert cache_directory({"XDG_CACHE_HOME": "/c"}) == Path("/c/onika")
    assert cache_directory({"XDG_CACHE_HOME": "c", "HOME": "/h"}) == Path("/h/.cache/onika")
