from dataclasses import replace

from kit.labs.sample_task import MS, SampleTask, law_task
from kit.runtime import law_comparison
from kit.runtime.executive_rig import HOME
from kit.runtime.law_comparison import Exchanged, by_executive, by_law
from onika.runtime import command

ON = command.Switch(HOME, (), (), (command.Launch("a"),))


def test_both_tell_the_same_of_an_honest_probe():
    probes, requests = [SampleTask("a", outvar=("V0",))], [(0, ON)]
    trace, reference = by_law(probes, requests, 20 * MS)
    assert by_executive(probes, requests, 20 * MS) == trace
    assert [entry.at // MS for entry in reference.trace if entry.entry == "cycle"] == [0, 10, 20]


def test_an_exchange_is_told_by_both():
    probe = SampleTask("a", outvar=("V0",))
    requests = [(0, ON), (15 * MS, Exchanged(replace(probe, takes=True)))]
    trace, _ = by_law([probe], requests, 30 * MS)
    assert by_executive([probe], requests, 30 * MS) == trace
    assert (15 * MS, "a", "swapped") in trace.words


def test_a_law_that_says_something_else_is_found(monkeypatch):
    monkeypatch.setattr(law_comparison, "law_task", lambda probe: law_task(replace(probe, finish_after=2)))
    probes, requests = [SampleTask("a", outvar=("V0",))], [(0, ON)]
    assert by_law(probes, requests, 20 * MS)[0] != by_executive(probes, requests, 20 * MS)
