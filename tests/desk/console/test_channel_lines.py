from onika.wire import holding
from onika.words.reason import Reason


def test_where_it_is_open_already_the_channel_is_named(sit):  # R-A16
    sitting = sit(addresses=("127.0.0.1:7994",))
    for line in ("open", "listen 127.0.0.1:7994", "network"):
        assert sitting.does(line) == ["others reach this runtime at 127.0.0.1:7994"]
    fault = sitting.fails("open 0.0.0.0:1")
    assert fault.reason == Reason.of("console.listens_elsewhere", addresses="127.0.0.1:7994")
    assert "`close` comes first" in str(fault.instead)
    assert sitting.requests_of(holding.Listen) == []


def test_a_closed_runtime_is_opened_to_this_machine_and_the_token_told_once(sit):  # R-A16
    sitting = sit()
    output = sitting.does("network")
    assert output == [
        "others reach this runtime at ws://127.0.0.1:7994",
        "programs of this user come in as its owner, with the token in /state/token",
        "others of this machine come in as viewer with the token tell-me-once, which is told only now",
    ]
    assert sitting.does("open") == output[:1]
    assert sitting.requests_of(holding.Listen) == [holding.Listen("127.0.0.1:7994")]


def test_it_is_closed_again(sit):  # R-A16
    sitting = sit()
    sitting.does("listen 127.0.0.1:8000 operator")
    assert sitting.does("close") == ["nobody else reaches this runtime any more"]
    sitting.does("listen 127.0.0.1:8001")
    roles = [(message.place, message.role) for message in sitting.requests_of(holding.Listen)]
    assert roles == [("127.0.0.1:8000", "operator"), ("127.0.0.1:8001", "viewer")]


def test_beyond_this_machine_it_takes_a_certificate_and_users(sit):  # R-A16
    sitting = sit()
    sitting.does("open 0.0.0.0:7994 cert=c.pem key=k.pem users=people")
    assert sitting.requests_of(holding.Listen) == [
        holding.Listen("0.0.0.0:7994", "viewer", certificate="c.pem", key="k.pem", users="people")
    ]


def test_words_that_mean_nothing_are_refused_with_those_that_do(sit):  # R-A16
    sitting = sit()
    for line, word in (("open 127.0.0.1:1 king", "king"), ("open 127.0.0.1:1 cert=", "cert="), ("open a=b", "a=b")):
        assert sitting.fails(line).reason == Reason.of(
            "console.listen_words", roles=("viewer", "operator", "programmer", "owner"), word=word
        )
    assert sitting.requests_of(holding.Listen) == []


def test_what_the_runtime_refuses_is_told(sit):  # R-A16, R-X12
    sitting = sit()
    sitting.runtime.refusals.update(Listen=Reason.plain("only its owner may"), StopListening=Reason.plain("not you"))
    assert "only its owner may" in str(sitting.fails("open").reason)
    assert "not you" in str(sitting.fails("close").reason)
