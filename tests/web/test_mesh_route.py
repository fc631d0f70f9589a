import gzip
import http.client

import pytest

pytestmark = pytest.mark.site

NAME = "0" * 32


def get(served, path, **headers):
    """An answer with its body."""
    link = http.client.HTTPConnection(served.address, timeout=60)
    link.request("GET", path, headers={"Host": served.address, **headers})
    answer = link.getresponse()
    body = answer.read()
    link.close()
    return answer, body


def test_a_mesh_is_given_packed_to_whoever_has_the_key(served):  # R-X19
    path = f"/mesh/{NAME}"
    key = get(served, f"/?key={served.login.key}")[0].headers["set-cookie"].partition(";")[0]
    assert get(served, path, Cookie=key)[0].status == 404
    served.meshes.keep({NAME: b"corners"})
    assert get(served, path)[0].status == 403
    assert get(served, path, Cookie=key, Host="evil.example")[0].status == 421
    plain, body = get(served, path, Cookie=key)
    assert (plain.status, body, plain.headers["content-encoding"]) == (200, b"corners", None)
    packed, body = get(served, path, **{"Cookie": key, "Accept-Encoding": "gzip"})
    assert (packed.headers["content-encoding"], gzip.decompress(body)) == ("gzip", b"corners")
    assert "immutable" in packed.headers["cache-control"]
