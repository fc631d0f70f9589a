import pytest

from onika.wire.rendezvous import MOST_TAGS, Phase, RendezvousReport, TagState, decode, encode

MET = TagState(Phase.MET, 4, 7, 1, 10**18, has_begun=True)
PASSED = TagState(Phase.MET, 2**32 - 1, 0, 255, -1, was_passed=True)


def report(*tags, is_stopped=False):
    return RendezvousReport(bytes(range(16)), 2**63, 3, 10**15, 5, 6, tags, is_stopped)


@pytest.mark.parametrize(
    "said", [report(), report(MET), report(TagState(), MET, PASSED, is_stopped=True), report(*[MET] * MOST_TAGS)]
)
def test_what_is_said_is_what_is_understood(said):  # R-E04
    assert decode(encode(said)) == said


def test_all_that_can_be_said_fits_into_one_datagram():
    assert len(encode(report(*[MET] * MOST_TAGS))) < 1_200
    assert len(encode(report(*[MET] * 3))) < 110


@pytest.mark.parametrize(
    "body",
    [
        b"",
        encode(report())[:-1],
        encode(report(MET))[:-1],
        encode(report(MET)) + b"x",
        encode(report(*[MET] * (MOST_TAGS + 1))),
        encode(report())[:50] + b"\x07" + encode(report(MET))[51:],
    ],
)
def test_what_is_no_report_is_none(body):
    assert decode(body) is None
