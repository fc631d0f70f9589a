from hashlib import blake2b

from onika.link.datagrams import pact
from onika.link.datagrams.pact import Pact

NAME, KEY = bytes(range(8)), bytes(range(32))
PACT = Pact(NAME, KEY)


def test_what_was_sealed_by_a_pact_is_opened_by_it():  # R-X12
    for body in (b"", b"said", bytes(1_200)):
        assert PACT.open(PACT.seal(7, body)) == (7, body)
    assert PACT.open(PACT.seal(2**64 - 1, b"")) == (2**64 - 1, b"")


def test_a_datagram_that_was_changed_anywhere_counts_no_more():  # R-X12
    datagram = PACT.seal(7, b"said")
    for place in range(len(datagram)):
        wrong = bytearray(datagram)
        wrong[place] ^= 1
        assert PACT.open(bytes(wrong)) is None
    assert [PACT.open(datagram[:length]) for length in range(len(datagram))] == [None] * len(datagram)


def test_who_does_not_know_the_key_cannot_seal():
    assert PACT.open(Pact(NAME, bytes(32)).seal(1, b"")) is None
    assert PACT.open(Pact(bytes(8), KEY).seal(1, b"")) is None
    short = NAME + b"\0" * 7
    assert PACT.open(short + blake2b(short, digest_size=16, key=KEY).digest()) is None


def test_each_pact_is_another_and_none_shows_its_key():
    first = Pact.drawn()
    assert first != Pact.drawn()
    assert (len(first.name), len(first.key)) == (8, 32)
    assert (pact.NAME, pact.COUNT, pact.SEAL, pact.KEY) == (8, 8, 16, 32)
    assert repr(PACT) == f"Pact(name={NAME.hex()})"
