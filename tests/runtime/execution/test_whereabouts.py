from onika.runtime.execution.whereabouts import Whereabouts


def test_whose_code_runs_is_noted_and_told():
    told, running = [], Whereabouts()
    running("flow0/a")
    assert (running.task, running.calls) == ("flow0/a", 1)
    running.also = told.append
    running("")
    assert (running.task, running.calls, told) == ("", 2, [""])
