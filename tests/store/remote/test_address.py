from pathlib import Path

import pytest

from onika.store.remote.address import WebAddress, library_address, web_address
from onika.words.reason import Reason


def test_an_address_is_taken_apart():  # R-F03
    assert web_address("https://robots.cmu.edu/library/puma/") == WebAddress(
        True, "robots.cmu.edu", 443, "/library/puma/"
    )
    ours = web_address("http://[::1]:8000")
    assert isinstance(ours, WebAddress)
    assert (ours.authority, ours.below("library"), ours.keeps_secrets) == ("[::1]:8000", "/library", True)


def test_a_folder_is_an_address_too(tmp_path):  # R-F03
    assert library_address(str(tmp_path)) == tmp_path
    assert library_address("~/stick") == Path.home() / "stick"


@pytest.mark.parametrize(
    "text",
    [
        "ftp://host/x",
        "https://",
        "https:///path",
        "https://host:port/",
        "https://ho st/",
        "https://h\nost/",
        "",
        "a\0b",
    ],
)
def test_what_is_no_address_is_refused(text):  # R-X16
    reason = library_address(text)
    assert isinstance(reason, Reason) and reason.key == "store.address_form"


def test_no_password_stands_in_an_address():  # R-X16
    reason = library_address("https://ann:secret@host/x")
    assert isinstance(reason, Reason) and reason.key == "store.address_password"
    assert "secret" not in str(reason)


def test_only_the_same_server_may_send_us_on():  # R-X16
    ours = web_address("https://host/library")
    assert isinstance(ours, WebAddress)
    assert ours.redirected("/library/x", "/other/x?y=1") == "/other/x?y=1"
    assert ours.redirected("/library/x", "https://host:443/z") == "/z"
    for location in ("http://host/x", "https://host:444/x", "https://host.evil/x", "https://u:p@host/x", "//evil/"):
        assert isinstance(ours.redirected("/library/x", location), Reason)
