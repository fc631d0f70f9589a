from onika.host.loading.module_description import describe
from onika.host.loading.module_facts import ModuleFacts
from onika.wire.plan import Code

GOOD = """
from onika.module import Module, OutVar

class Good(Module):
    X = OutVar("double[6]", "rad", "where it is")
"""


def test_modules_are_described_each_by_its_code_and_the_bad_ones_with_why():  # law 24
    codes = (Code("1", "good", "good.py", GOOD), Code("2", "bad", "bad.py", "import nowhere_at_all\n"))
    told = describe(codes, ModuleFacts())
    assert [(one.name, one.shape, one.unit, one.meaning) for one in told.sheets["1"].ports] == [
        ("X", "double[6]", "rad", "where it is")
    ]
    assert set(told.faults) == {"2"} and "nowhere_at_all" in str(told.faults["2"])
