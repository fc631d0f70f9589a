from dataclasses import replace

import pytest

from kit.fabric.announced_site import CARD, signer
from onika.fabric.card import LARGEST, OfferedRuntime, read, write
from onika.words.reason import Reason


def test_a_card_is_read_as_it_was_written():  # R-F06
    assert read(write(CARD)) == CARD
    rolling = replace(CARD, next_key=signer("b"), runtimes=(), libraries=(), description="")
    assert read(write(rolling)) == rolling


@pytest.mark.parametrize(
    "wrong",
    [
        replace(CARD, name="no name"),
        replace(CARD, name="n" * 61),
        replace(CARD, serial=0),
        replace(CARD, next_key="SHA256:short"),
        replace(CARD, runtimes=(OfferedRuntime("ssh://robots.cmu.edu"),)),
        replace(CARD, runtimes=(OfferedRuntime("wss://a:1", ("r m", "-x")),)),
        replace(CARD, runtimes=CARD.runtimes * 9),
        replace(CARD, libraries=("file:///etc",)),
        replace(CARD, libraries=("https://ann:secret@far/x",)),
    ],
)
def test_what_is_no_card_is_not_written(wrong):  # R-F06
    with pytest.raises(ValueError) as raised:
        write(wrong)
    assert isinstance(raised.value.args[0], Reason)


@pytest.mark.parametrize(
    "altered",
    [
        lambda text: text + b"EOF\n",
        lambda text: text.replace(b"EOF\n", b""),
        lambda text: text.replace(b"SERIAL", b"SERIOUS"),
        lambda text: text + text,
        lambda text: text.replace(b"2026-12-24", b"soon"),
        lambda text: text.replace(b"Our PUMA", b"\xff\xfe"),
        lambda text: text.replace(b"Our PUMA", b"x" * LARGEST),
        lambda text: b"",
    ],
)
def test_a_text_that_is_no_card_is_refused_with_words(altered):  # R-F06
    refused = read(altered(write(CARD)))
    assert isinstance(refused, Reason)
    assert refused.key.startswith("fabric.card_")


def test_a_description_stays_one_line_whatever_it_holds():  # R-F06
    card = read(write(replace(CARD, description="a\nRUNTIME wss://evil:1\x1b[2J")))
    assert card.runtimes == CARD.runtimes
    assert card.description.isprintable()
