import asyncio
import gzip

import pytest
from starlette.exceptions import HTTPException

from onika.web.packed_files import PackedFiles


@pytest.fixture
def answered(tmp_path):
    """What is answered to who asks for a file of a page, and says so what he takes."""
    for name in ("page.js", "page.css"):
        (tmp_path / name).write_text(name)
    (tmp_path / "page.js.gz").write_bytes(gzip.compress(b"packed"))
    files = PackedFiles(directory=tmp_path)

    def ask(path, takes=""):
        scope = {"type": "http", "method": "GET", "headers": [(b"accept-encoding", takes.encode())]}
        response = asyncio.run(files.get_response(path, scope))
        return response.path.removeprefix(f"{tmp_path}/"), dict(response.headers)

    return ask


def test_who_takes_gzip_gets_the_packed_file_as_what_it_is_within(answered):  # R-F10
    path, headers = answered("page.js", "br, gzip")
    assert path == "page.js.gz"
    assert headers["content-encoding"] == "gzip"
    assert headers["content-type"].startswith("text/javascript")
    assert headers["vary"] == "accept-encoding"


@pytest.mark.parametrize(("path", "takes"), [("page.js", ""), ("page.js", "br"), ("page.css", "gzip")])
def test_others_and_what_is_not_packed_get_the_file_itself(answered, path, takes):
    found, headers = answered(path, takes)
    assert found == path
    assert "content-encoding" not in headers
    assert headers["vary"] == "accept-encoding"


def test_what_is_not_there_is_not_there_packed_either(answered):
    with pytest.raises(HTTPException):
        answered("nothing.js", "gzip")
