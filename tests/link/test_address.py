import pytest

from onika.link.address import PORT, Address, bracketed, is_near, split_host


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("wss://robot.example:8000", Address("robot.example", 8000, True)),
        ("wss://robot.example", Address("robot.example", PORT, True)),
        ("ws://127.0.0.1:1/", Address("127.0.0.1", 1, False)),
        ("ws://localhost", Address("localhost", PORT, False)),
        ("ws://[::1]:5", Address("::1", 5, False)),
    ],
)
def test_an_address_is_read_and_written(text, address):  # R-A15
    assert Address.parse(text) == address
    assert Address.parse(str(address)) == address


@pytest.mark.parametrize(
    "text",
    [
        "",
        "robot",
        "http://robot",
        "ws://",
        "wss://robot:99999",
        "wss://robot:x",
        "wss://u@robot",
        "wss://robot/x",
        "wss://robot?x",
    ],
)
def test_what_is_no_address_is_told(text):
    with pytest.raises(ValueError, match="expected"):
        Address.parse(text)


@pytest.mark.parametrize("text", ["ws://robot", "ws://192.0.2.1:1", "ws://0.0.0.0"])
def test_a_token_never_goes_over_a_network_in_the_clear(text):
    with pytest.raises(ValueError, match="expected wss:// for another machine"):
        Address.parse(text)


@pytest.mark.parametrize(
    ("host", "near"),
    [("localhost", True), ("127.9.9.9", True), ("::1", True), ("::ffff:127.0.0.1", True), ("0.0.0.0", False),
     ("::", False), ("192.0.2.1", False), ("localhost.example", False), ("fe80::1%eth0", False)],
)  # fmt: skip
def test_only_this_machine_is_near(host, near):
    assert is_near(host) is near


def test_host_and_port_are_parted():
    assert split_host("robot:8") == ("robot", 8)
    assert split_host("[::1]:8") == ("::1", 8)
    assert split_host("robot") == ("robot", None)
    assert bracketed("::1") == "[::1]"
    for text in ("", ":8", "a:b", "robot/x", "u@robot"):
        with pytest.raises(ValueError):
            split_host(text)
