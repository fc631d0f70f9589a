from hypothesis import given, strategies as st

from onika.model.configuration import Locus
from onika.model.port import PortKind
from onika.model.rules.uses import apart, of_locus, of_task, tasks

KINDS = {
    PortKind.INCONST: "inconst",
    PortKind.OUTCONST: "outconst",
    PortKind.INVAR: "invar",
    PortKind.OUTVAR: "outvar",
    PortKind.INBOTH: "double_in",
    PortKind.OUTBOTH: "outconst",
}
pins = st.lists(st.tuples(st.sampled_from("ABC"), st.sampled_from(list(PortKind))), max_size=6)


@given(st.lists(pins, max_size=20))
def test_counts_of_tasks_are_added_as_a_file_counts_them(found):  # R-C24, reading 7
    for svar in "ABC":
        total = sum(of_task(one).get(svar, 0) for one in found)
        using = [one for one in found if any(name == svar for name, _ in one)]
        counts = dict.fromkeys(("inconst", "outconst", "invar", "outvar", "double_in"), 0)
        for one in using:
            for name, kind in one:
                counts[KINDS[kind]] += name == svar
        assert total == of_locus(Locus(svar, conns=len(using), **counts))
        assert apart(total) == (len(using), *counts.values())
        assert tasks(total) == len(using)
