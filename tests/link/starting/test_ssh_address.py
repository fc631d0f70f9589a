"""Addresses of runtimes that ssh starts; nothing gets through that ssh or a shell could take for more than a word."""

import shlex

import pytest
from hypothesis import given, strategies as st

from onika.link.starting.ssh_address import SshAddress


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("ssh://robot", SshAddress("robot")),
        ("ssh://ann@arm.example.org:2222", SshAddress("arm.example.org", "ann", 2222)),
        ("ssh://robot/opt/lab/bin/onika?virtual", SshAddress("robot", program="/opt/lab/bin/onika", is_virtual=True)),
        ("ssh://[::1]?stay&unit=left&unit=right", SshAddress("::1", stays=True, units=("left", "right"))),
        ("ssh://robot/?virtual&stay", SshAddress("robot", is_virtual=True, stays=True)),
    ],
)
def test_an_address_is_read_and_written(text, address):  # R-A15
    assert SshAddress.parse(text) == address
    assert SshAddress.parse(str(address)) == address


@pytest.mark.parametrize(
    "text",
    [
        "ssh://", "ssh:robot", "http://robot", "ssh://-oProxyCommand=sh", "ssh://-l@robot", "ssh://a b", "ssh://ro;bot",
        "ssh://robot:0", "ssh://robot:x", "ssh://robot:99999", "ssh://ann:secret@robot", "ssh://robot#now",
        "ssh://robot/opt/$(reboot)", "ssh://robot/opt/a b", "ssh://robot/opt;reboot", "ssh://$USER@robot", "ssh://[::1",
    ],
)  # fmt: skip
def test_what_is_no_address_is_refused_with_what_was_expected(text):  # R-A15
    with pytest.raises(ValueError, match="expected ssh://") as wrong:
        SshAddress.parse(text)
    assert text in str(wrong.value)


@pytest.mark.parametrize("word", ["fast", "virtual=1", "unit=", "unit=a;b", "stay=yes"])
def test_a_word_that_is_not_known_is_named(word):  # R-A15
    with pytest.raises(ValueError, match="expected virtual, stay or unit=NAME") as wrong:
        SshAddress.parse(f"ssh://robot?{word}")
    assert word.removeprefix("unit=").split("=")[0] in str(wrong.value)


def test_where_to_stands_behind_all_that_is_an_option_and_what_is_started_is_one_command():  # R-A15
    address = SshAddress.parse("ssh://ann@robot:2222/opt/onika?virtual&stay&unit=left")
    assert address.place == ("-p", "2222", "-l", "ann", "--", "robot")
    assert address.command == "/opt/onika runtime --hand-over --virtual --stay --rtpu left"
    assert SshAddress("robot").command == "onika runtime --hand-over"


@given(st.text(max_size=30))
def test_whatever_is_let_through_stays_the_words_that_it_was(text):  # R-A15
    for address in (f"ssh://{text}", f"ssh://robot/{text}", f"ssh://robot?unit={text}"):
        try:
            parsed = SshAddress.parse(address)
        except ValueError:
            continue
        words = shlex.split(parsed.command)
        assert words[1:3] == ["runtime", "--hand-over"]
        assert not {"`", "$", ";", "&", "|", "\n", ">", "<"} & set(parsed.command)
        assert parsed.place[-2] == "--"
        assert not parsed.place[-1].startswith("-")
