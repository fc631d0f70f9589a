from hypothesis import given, strategies as st

from onika.model.rules import placement
from onika.model.rules.conflict import conflicts
from onika.model.task import Task

_PORTS = st.lists(st.sampled_from("ABCD"), max_size=2, unique=True).map(tuple)
_TASKS = st.lists(
    st.builds(
        Task,
        name=st.sampled_from("stuvw"),
        module=st.sampled_from("klmno"),
        inconst=_PORTS,
        outconst=_PORTS,
        invar=_PORTS,
        outvar=_PORTS,
    ),
    max_size=6,
)


@given(_TASKS, st.integers(0, 6))
def test_every_pair_that_may_not_stand_together_is_found_with_its_reasons(tasks, new):  # R-C26, Equations (2) and (3)
    expected = [
        (later, earlier, refusals)
        for at, later in enumerate(tasks)
        for earlier in tasks[:at]
        if at >= new and (refusals := placement.refusals(later, [earlier]))
    ]
    assert list(conflicts(tasks, new)) == expected
    assert list(conflicts(tasks))[len(list(conflicts(tasks))) - len(expected) :] == expected
