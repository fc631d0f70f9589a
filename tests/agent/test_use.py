from onika.agent.use import FIRST_NS, LAST_NS, RuntimeUse


def test_whoever_launches_has_time_to_come():  # R-A15
    use = RuntimeUse(0)
    assert not use.look(FIRST_NS - 1, is_used=False)
    assert use.look(FIRST_NS, is_used=False)


def test_it_ends_some_time_after_the_last_one_has_gone():  # R-A15
    use = RuntimeUse(0)
    assert not use.look(FIRST_NS * 5, is_used=True)
    assert not use.look(FIRST_NS * 5 + LAST_NS - 1, is_used=False)
    assert not use.look(FIRST_NS * 5 + LAST_NS, is_used=True)
    assert use.look(FIRST_NS * 5 + 2 * LAST_NS, is_used=False)
