from onika.desk.environment.runs.readiness_refusal import refused
from onika.desk.environment.state.open_application import OpenApplication
from onika.model.application import Application
from onika.wire.view import FaultView, Remedy
from onika.words.reason import Reason

HERE = OpenApplication("a1", Application("play", False, ()))


def test_what_has_no_faults_is_not_refused():
    assert refused(HERE, (FaultView(Reason.plain("odd"), "warning"),)) is None


def test_everything_is_told_at_once_each_with_its_first_remedy():  # R-E01, R-X01
    faults = [
        FaultView(
            Reason.plain(f"fault {n}"), "fault", n, (Remedy(Reason.plain(f"mend {n}")), Remedy(Reason.plain("show")))
        )
        for n in range(12)
    ]
    no = refused(HERE, faults)
    assert str(no.reason).startswith("play cannot run: 12 things: fault 0; fault 1")
    assert str(no.reason).endswith("; and 4 more")
    assert [str(remedy.label) for remedy in no.remedies] == [f"mend {n}" for n in range(6)]


def test_one_fault_is_told_alone():
    assert str(refused(HERE, (FaultView(Reason.plain("a hole")),)).reason) == "play cannot run: a hole"
