"""A process that asks a router: whatever it says, or does not say, is bounded."""

import base64
import sys
import time

import pytest

from onika.fabric import router_cards as asking
from onika.fabric.place import RouterPlace
from onika.fabric.router_cards import router_cards

PLACE = RouterPlace("tcp/127.0.0.1:1")


def said(code, patience_s=5.0):
    return router_cards(PLACE, patience_s, (sys.executable, "-c", f"import sys, time; {code}"))


def test_the_cards_that_it_writes_are_taken_and_noise_is_not():  # R-F06
    line = base64.b64encode(b"a card").decode()
    large = base64.b64encode(b"x" * 5000).decode()
    assert said(f"print({line!r}); print('%%%'); print({large!r}); print('END')") == (b"a card",)


@pytest.mark.parametrize("code", ["pass", "sys.exit(1)", "print('YQ==')"])
def test_one_that_does_not_come_to_its_end_says_that_nobody_answered(code):  # R-F06
    assert said(code).key == "fabric.router_silent"


def test_one_that_never_ends_is_ended():  # R-F06
    began_s = time.monotonic()
    assert said("time.sleep(60)", patience_s=0.3).key == "fabric.router_silent"
    assert time.monotonic() - began_s < 10


def test_one_that_floods_is_ended(monkeypatch):  # R-F06
    monkeypatch.setattr(asking, "_MOST_BYTES", 100_000)
    assert said("[sys.stdout.write('A' * 4000 + chr(10)) for _ in range(10**6)]").key == "fabric.book_many"


def test_without_zenoh_it_is_said_how_it_comes(monkeypatch):  # R-F06
    monkeypatch.setattr(asking, "find_spec", lambda name: None)
    assert router_cards(PLACE, 1.0).key == "fabric.no_zenoh"
