"""What an engine knows can be taken out and put back."""

from kit.engine.engine_memory import EngineMemory
from kit.plans.program_tree import Act, Loop, engine_for, planned
from onika.engine import news

LOOP = (Loop("l", (Act("a"), Act())),)


def spawned():
    engine = engine_for(planned(LOOP, LOOP), stands_still=True)
    engine.feed(news.Run())
    for flow in range(2):
        for task in ("move", "arm"):
            engine.feed(news.Spawned(flow, task))
    return engine


def finish(engine, flow):
    """What follows when the present action ends and the loop goes on."""
    engine.feed(news.TurnedOn(flow, "move"))
    return engine.feed(news.Finished(flow, "move", loop=True))


def test_an_engine_that_was_put_back_does_the_same_again():
    engine = spawned()
    memory = EngineMemory(engine)
    before, key = memory.take(), memory.key()
    orders = finish(engine, 0)
    assert memory.key() != key
    memory.put_back(before)
    assert memory.key() == key
    assert finish(engine, 0) == orders


def test_the_key_forgets_how_often_flows_have_met():
    engine = spawned()
    memory = EngineMemory(engine)
    keys = []
    for _ in range(3):
        for flow in (0, 1):
            finish(engine, flow)  # action 0
        keys.append(memory.key())
        for flow in (0, 1):
            finish(engine, flow)  # action 1; then both meet
    assert keys[1] == keys[2]


def test_the_key_knows_who_waits_for_whom():
    engine = spawned()
    memory = EngineMemory(engine)
    keys = {memory.key()}
    finish(engine, 0)
    keys.add(memory.key())
    finish(engine, 0)
    keys.add(memory.key())
    assert len(keys) == 3
