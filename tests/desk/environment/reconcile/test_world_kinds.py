from dataclasses import replace

from kit.desk.run_fixture import RunFixture
from onika.desk.environment.reconcile.world_kinds import kinds, with_kinds
from onika.wire import view


def test_a_world_is_simulated_or_real_in_words():  # R-E09
    assert kinds({"boxes": True, "cell": False}) == {"boxes": "simulated", "cell": "real"}


def test_what_is_known_of_worlds_grows_and_the_last_word_counts(tmp_path):  # R-E09
    model = replace(RunFixture(tmp_path).environment.model, runtime=view.RuntimeView("linked"))
    assert with_kinds(model, {}) is model
    knowing = with_kinds(model, {"boxes": True, "cell": True})
    assert with_kinds(knowing, {"boxes": True}) is knowing
    assert with_kinds(knowing, {"cell": False}).runtime.world_kinds == {"boxes": "simulated", "cell": "real"}
