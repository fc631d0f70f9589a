import asyncio

import pytest

from onika.web.outbox import Outbox


@pytest.fixture
def sent():
    async def take(outbox, count):
        return [await asyncio.wait_for(outbox.next(), 5) for _ in range(count)]

    with asyncio.Runner() as runner:  # what waits for something belongs to one loop
        yield lambda outbox, count: runner.run(take(outbox, count))


@pytest.fixture
def outbox(sent):
    box = Outbox(lambda: b"everything")
    assert sent(box, 1) == [b"everything"]
    return box


def test_the_first_message_says_everything(sent):
    assert sent(Outbox(lambda: b"everything"), 1) == [b"everything"]


def test_patches_and_answers_keep_their_order(outbox, sent):
    outbox.patch(b"1")
    outbox.put(b"2")
    outbox.patch(b"3")
    assert sent(outbox, 3) == [b"1", b"2", b"3"]


def test_of_frames_the_newest_is_sent_and_after_all_else(outbox, sent):
    outbox.frame(b"old")
    outbox.put(b"answer")
    outbox.frame(b"new")
    assert sent(outbox, 2) == [b"answer", b"new"]


def test_who_is_too_slow_for_patches_is_told_everything_and_keeps_the_answers(outbox, sent):
    outbox.put(b"answer")
    for _ in range(6):
        outbox.patch(b"x" * 1024 * 1024)
    outbox.put(b"another")
    assert sent(outbox, 3) == [b"everything", b"answer", b"another"]
    outbox.patch(b"next")
    assert sent(outbox, 1) == [b"next"]


def test_patches_before_the_snapshot_are_part_of_it(sent):
    box = Outbox(lambda: b"everything")
    box.patch(b"1")
    box.put(b"answer")
    assert sent(box, 2) == [b"everything", b"answer"]


def test_whoever_waits_is_woken_by_what_comes():
    async def waits():
        outbox = Outbox(lambda: b"everything")
        first = await outbox.next()
        waiting = asyncio.ensure_future(outbox.next())
        await asyncio.sleep(0)
        assert not waiting.done()
        outbox.put(b"answer")
        return [first, await waiting]

    assert asyncio.run(waits()) == [b"everything", b"answer"]
