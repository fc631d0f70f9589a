from onika.link import lost
from onika.link.lost import LinkLost, LossCause
from onika.words.reason import NOTHING, Reason, in_language


def test_each_cause_says_distinctly_what_happened():  # R-F01
    sentences = [
        lost.closed(Reason.plain("connection reset")),
        lost.silent(3.04),
        lost.version(1, 2),
        lost.garbage(Reason.plain("no packet")),
        lost.behind(Reason.plain("too many bytes")),
        lost.here(),
    ]
    opening = {
        LossCause.REFUSED,
        LossCause.UNREACHABLE,
        LossCause.TIMEOUT,
        LossCause.CERTIFICATE,
        LossCause.TOKEN,
        LossCause.FORBIDDEN,
        LossCause.OVER,
    }
    assert {why.cause for why in sentences} == set(LossCause) - opening
    assert len({str(why) for why in sentences}) == len(sentences)


def test_what_trying_again_does_not_mend_is_final():
    final = {cause for cause in LossCause if LinkLost(cause, NOTHING).is_final}
    assert final == {LossCause.VERSION, LossCause.CERTIFICATE, LossCause.TOKEN, LossCause.FORBIDDEN, LossCause.OVER}


def test_a_good_bye_says_its_cause():
    refused = lost.link_lost("refused", Reason.of("link.sessions_full", count=32))
    assert (lost.link_lost("closed", NOTHING).cause, refused.cause) == (LossCause.CLOSED, LossCause.REFUSED)
    assert str(refused) == "the other side ended the connection: there are 32 sessions already"


def test_the_words_hold_the_numbers_that_matter():
    assert str(lost.silent(3.04)) == "the other side has been silent for 3.0 s"
    assert "version 2" in str(lost.version(1, 2))
    assert "connection reset" in str(lost.closed(Reason.plain("connection reset")))
    assert str(lost.closed()) == "the other side closed the connection"


def test_why_a_link_was_lost_is_said_in_spanish_too():  # R-G03
    assert in_language(lost.silent(3.04).reason, "es") == "el otro lado calla desde hace 3,0 s"
    assert in_language(lost.closed(Reason.plain("reset")).reason, "es") == "el otro lado cerró la conexión: reset"


def test_a_good_bye_of_the_other_side_is_said_in_spanish():  # R-G03
    refused = lost.link_lost("refused", Reason.of("link.sessions_full", count=32))
    assert in_language(refused.reason, "es") == "el otro lado terminó la conexión: ya hay 32 sesiones"
    other_version = lost.link_lost("version", Reason.plain("this runtime speaks version 9 of the link, not 3"))
    assert in_language(other_version.reason, "es").startswith("el otro lado no habla la versión ")
