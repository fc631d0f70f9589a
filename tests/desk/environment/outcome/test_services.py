from onika.desk.environment.outcome.services import Services
from onika.store.shipped import shipped
from onika.store.site import Site


def test_nothing_outlives_a_session_and_no_command_runs_unless_it_says_so():
    outside = Services(Site((), shipped() / "prefs"), lambda: 1.5)
    assert (outside.clock(), outside.state, outside.commands) == (1.5, None, None)
    assert (outside.reading, outside.comparing) == (None, None)
