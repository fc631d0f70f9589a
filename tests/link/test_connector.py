import threading

from onika.link.carrier import memory_pair, wait_for
from onika.link.channel import Channel
from onika.link.connector import ThreadConnector
from onika.link.lost import LinkLost, LossCause
from onika.words.reason import Reason


def test_what_was_opened_and_what_was_not_is_told_and_wakes_the_waiting():
    here, _ = memory_pair()

    def opening(channel):
        if channel is Channel.SIGNAL:
            raise LinkLost(LossCause.TOKEN, Reason.plain("wrong"))
        return here

    connector = ThreadConnector(opening)
    connector.dial(Channel.SESSION)
    connector.dial(Channel.SIGNAL)
    came = []
    while len(came) < 2:
        wait_for([connector], 5.0)
        came += connector.finished()
    results = dict(came)
    assert results[Channel.SESSION] is here
    assert results[Channel.SIGNAL].cause is LossCause.TOKEN
    assert connector.finished() == []
    connector.close()
    connector.close()
    assert connector.fileno() == -1


def test_what_comes_after_the_end_is_let_go():
    here, there = memory_pair()
    go = threading.Event()

    def opening(_channel):
        go.wait(5.0)
        return here

    connector = ThreadConnector(opening)
    connector.dial(Channel.SESSION)
    connector.close()
    go.set()
    for thread in threading.enumerate():
        if thread.name == "onika SESSION":
            thread.join(5.0)
    try:
        there.receive()
    except LinkLost as lost:
        assert lost.cause is LossCause.CLOSED
    else:
        raise AssertionError("it was kept")
