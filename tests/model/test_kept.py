from onika.model.kept import Demand, KeptAction, KeptRun


def test_a_kept_run_asks_only_for_what_was_kept():  # R-X07
    action = KeptAction("opengripC", 0.18, 0.05)
    assert (action.after, action.is_on_way) == ((), False)
    assert (Demand("LAMP", (1.0,)).tolerance, KeptRun("assemble", "", ()).meetings) == (0.0, ())
