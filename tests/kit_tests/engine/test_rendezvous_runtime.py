from kit.engine.rendezvous_runtime import VISITS
from kit.engine.rendezvous_sim import MS, RendezvousHistory


def test_runtimes_come_to_the_tag_and_to_their_end():
    history = RendezvousHistory(0, MS)
    oracle = history.run()
    assert (oracle.faults, oracle.met) == ([], VISITS)
    assert all(runtime.is_done for runtime in history.runtimes)


def test_a_program_that_is_frozen_does_later_what_it_was_to_do():
    history = RendezvousHistory(0, MS)
    runtime, done = history.runtimes[0], []
    runtime.soon(lambda: done.append("at once"))
    runtime.frozen_ns = 5 * MS
    runtime.soon(lambda: done.append(history.now_ns))
    while history.time.step(5 * MS):
        pass
    assert done == ["at once", 5 * MS]
