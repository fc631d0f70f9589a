from dataclasses import replace

import pytest

from onika.desk.run.settings import RunSettings, RuntimeLocation
from onika.desk.trial import keeping
from onika.desk.trial.account import RunAccount
from onika.desk.trial.keeping import keep, keep_in
from onika.files import kept
from onika.model.kept import Demand, KeptMeeting
from onika.store.site import open_site
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

SITE = open_site([], {}, None)
SETTINGS = RunSettings("assemble", is_virtual=True)


@pytest.fixture
def repeated(workshop, monkeypatch):
    """Every run is the usual one of the workshop, a little off where it is shaken; what was asked for."""
    attempts = []

    def give_account(settings, site):
        attempts.append(settings)
        return workshop.run(off=1e-4 * (settings.shake or 0), force=60.0 + (settings.shake or 0))

    monkeypatch.setattr(keeping, "give_account", give_account)
    return attempts


def test_what_robots_reach_and_what_is_measured_is_kept_and_forces_are_not(workshop):  # R-X07
    result = workshop.kept(workshop.run(force=17.0)).kept
    above, shut = result.flows[0].actions[1], result.flows[0].actions[3]
    assert above.after == (Demand("Q_MEZ", (0.5,), "rad", 0.005), Demand("Q_REF", (0.5,), "rad", 0.005))
    assert shut.after == (Demand("GRIP_MEZ[0]", (0.08,), "m", 0.002), Demand("GRIP", (-1.0,), "", 0.01))
    assert (above.lasts_s, above.within_s) == (1.0, 0.05)
    assert result.meetings == (KeptMeeting("meet", ("flow0", "flow1")),)


def test_a_lamp_is_told_when_it_changes_and_in_the_end(workshop):  # R-X07
    flow = workshop.kept().kept.flows[0]
    values = [
        (at, each.values) for at, action in enumerate(flow.actions) for each in action.after if each.address == "LAMP"
    ]
    assert values == [(0, (0.0,)), (7, (1.0,))]
    assert Demand("LAMP", (1.0,)) in flow.at_end


def on_the_way(result):
    return [at for at, action in enumerate(result.kept.flows[0].actions) if action.is_on_way]


def test_a_lift_is_on_the_way_and_so_is_no_place_that_may_be_the_purpose(workshop):  # R-X07
    assert on_the_way(workshop.kept()) == [1, 4]  # away from where the hand opened, and from where it closed
    tour = ["move aside", "move above", "move aside", "move above", "move stack"]
    assert on_the_way(workshop.kept(way=tour)) == []
    assert on_the_way(workshop.kept(way=["open", *tour, "close"])) == [1]


def test_a_reference_that_the_next_trigger_has_overwritten_already_is_not_kept(workshop):  # R-X07
    account = workshop.run(("open", "close"))
    account.parts[0].passed[0].values["GRIP"] = (-1.0,)
    shut = replace(account.parts[0].passed[1].variables[2], writer="other")
    account.parts[0].passed[1].variables = (*account.parts[0].passed[1].variables[:2], shut)
    result = keeping.kept_of(SETTINGS, account, []).kept
    assert "GRIP" not in [each.address for each in result.flows[0].actions[0].after]


def test_what_varies_in_shaken_runs_is_asked_for_less_exactly(workshop):  # R-X07
    result = workshop.kept(workshop.run(off=0.006), workshop.run(off=0.001)).kept
    assert result.flows[0].actions[1].after[0].tolerance == 0.02


def test_runs_that_went_another_way_say_nothing_and_that_is_told(workshop):  # R-X07
    result = workshop.kept(workshop.run(("open",)), workshop.run(cause="aborted"), workshop.run())
    assert tuple(map(str, result.notes)) == ("2 of 3 shaken runs went another way, so that they say nothing",)
    assert result.kept is not None


def test_only_a_good_run_can_be_kept(workshop):  # R-X07
    assert (
        str(workshop.kept(cause="stopped").refusal) == "only a run that comes to its end can be kept; this one: stopped"
    )
    assert "LAMP == 1 does not hold" in str(workshop.kept(expectations=[("LAMP == 1", 0, False)]).refusal)
    fault = Fault(Place("a.appl", 3), Reason.plain("expected one, found two"), Reason.plain("it is not run"))
    assert str(workshop.kept(refusals=(fault,), cause="x").refusal) == str(fault)


@pytest.mark.parametrize(
    ("more", "remedy"),
    [
        ({"is_virtual": False}, "give --virtual"),
        ({"elsewhere": RuntimeLocation("ws://127.0.0.1:1")}, "leave out --runtime"),
        ({"subsystems": ("left",)}, "leave out --subsystem"),
    ],
)
def test_what_no_test_could_do_again_is_refused_with_a_remedy(more, remedy):  # R-X07
    result = keep(replace(SETTINGS, **more), SITE)
    assert result.kept is None
    assert remedy in str(result.refusal)


def test_a_run_is_kept_with_others_of_other_seeds_in_shaken_worlds(repeated):  # R-X07
    result = keep(replace(SETTINGS, seed=5, expectations=(Condition.parse("LAMP == 1"),)), SITE, workers=2, shakes=3)
    assert [(attempt.seed, attempt.shake) for attempt in repeated] == [(5, None), (6, 6), (7, 7), (8, 8)]
    assert (result.kept.seed, result.kept.expectations, result.hash) == (5, ("LAMP == 1",), "h")


def test_one_run_after_the_other_is_told_how_far_it_is(repeated):  # R-X07
    progress = []
    keep(SETTINGS, SITE, shakes=2, progress=lambda *where: progress.append((*where, len(repeated))))
    assert progress == [(1, 3, 0), (2, 3, 1), (3, 3, 2)]


def test_others_of_a_run_that_cannot_be_kept_are_not_done(workshop, monkeypatch):  # R-X07
    done = []
    monkeypatch.setattr(keeping, "give_account", lambda *_: done.append(1) or workshop.run(cause="it fell"))
    assert "it fell" in str(keep(SETTINGS, SITE).refusal)
    assert len(done) == 1


def test_a_test_file_is_written_and_its_comments_stay(repeated, tmp_path):  # R-X07, R-B01
    path = tmp_path / "a.test"
    is_kept, messages = keep_in(path, SETTINGS, SITE, seen="h")
    assert (is_kept, tuple(map(str, messages))) == (True, ("9 actions, 23 values",))
    path.write_text(path.read_text().replace("END\n", "# the lamp\nEND\n"))
    assert keep_in(path, SETTINGS, SITE)[0]
    assert "# the lamp\nEND\n" in path.read_text()
    assert path.read_text().startswith("# A run of assemble, kept as a test")
    assert kept.read(path.read_text(), "a", "a.test")[0].application == "assemble"


def test_a_run_that_does_not_repeat_itself_is_told(repeated, tmp_path):  # R-X07
    assert "does not repeat itself" in str(keep_in(tmp_path / "a.test", SETTINGS, SITE, seen="another")[1][1])


def test_a_test_that_would_find_another_application_is_told(repeated, tmp_path):  # R-X07
    own = tmp_path / "lab" / "appl" / "mine.appl"
    own.parent.mkdir(parents=True)
    own.write_text("EOF\n")
    (tmp_path / "lab" / "tests").mkdir()
    settings = replace(SETTINGS, name=str(own))
    assert len(keep_in(tmp_path / "lab" / "tests" / "mine.test", settings, SITE)[1]) == 1
    assert f"--local {tmp_path / 'lab'}" in str(keep_in(tmp_path / "mine.test", settings, SITE)[1][1])


def test_what_cannot_be_written_is_told(repeated, tmp_path):  # R-B07
    is_kept, (reason,) = keep_in(tmp_path / "a.txt", SETTINGS, SITE)
    assert (is_kept, str(reason)) == (False, "a test is a file that ends with .test")
    assert keep_in(tmp_path / "nowhere" / "a.test", SETTINGS, SITE)[0] is False
    assert not keep_in(tmp_path / "a.test", replace(SETTINGS, is_virtual=False), SITE)[0]


def test_an_account_of_nothing_keeps_nothing():
    assert keeping.kept_of(SETTINGS, RunAccount(), []).kept.flows == ()
