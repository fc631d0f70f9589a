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
def test_counts_of_tasks_are_added_as_a_file_counts_them(result):  # R-C24, reading 7
    for svar in "ABC":
        total = sum(of_task(item).get(svar, 0) for item in result)
        using = [item for item in result if any(name == svar for name, _ in item)]
        counts = dict.fromkeys(("inconst", "outconst", "invar", "outvar", "double_in"), 0)
        for item in using:
            for name, kind in item:
                counts[KINDS[kind]] += name == svar
        assert total == of_locus(Locus(svar, conns=len(using), **counts))
        assert apart(total) == (len(using), *counts.values())
        assert tasks(total) == len(using)
