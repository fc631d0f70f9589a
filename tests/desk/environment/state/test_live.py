from onika.desk.environment.state.live import SubsystemFacts, TaskFacts


def test_a_subsystem_is_held_here_only_under_our_own_name():  # R-X12
    assert SubsystemFacts("main", holder="owner#1", me="owner#1").is_held_here
    assert not SubsystemFacts("main").is_held_here and not SubsystemFacts("main").is_foreign
    other = SubsystemFacts("main", holder="anna#2", me="owner#1")
    assert other.is_foreign and not other.is_held_here


def test_what_is_known_of_a_task_comes_and_goes():
    facts = SubsystemFacts("main").with_task("a", TaskFacts("ASKING"))
    assert facts.state_of("a") == "ASKING" and facts.tasks["a"].is_moving
    assert facts.with_task("a", None).state_of("a") == ""
