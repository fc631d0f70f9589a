from hashlib import sha256

from msgspec import structs

from onika.host.loading.module_description import describe
from onika.host.loading.module_facts import ModuleFacts
from onika.wire.plan import Code

GOOD = """
from onika.module import Module, OutVar

class Good(Module):
    X = OutVar("double[6]", "rad", "where it is")
"""


def test_modules_are_described_each_by_its_code_and_the_bad_ones_with_why():  # law 24
    good, bad = _code("good", GOOD), _code("bad", "import nowhere_at_all\n")
    description = describe((good, bad), ModuleFacts())
    assert [(port.name, port.shape, port.unit, port.meaning) for port in description.sheets[good.digest].ports] == [
        ("X", "double[6]", "rad", "where it is")
    ]
    assert set(description.faults) == {bad.digest} and "nowhere_at_all" in str(description.faults[bad.digest])


def test_code_under_the_digest_of_another_is_not_executed():  # R-F01, law 24
    foreign = structs.replace(_code("good", GOOD), source="raise SystemExit")
    description = describe((foreign,), ModuleFacts())
    assert not description.sheets
    assert "digest" in str(description.faults[foreign.digest])


def _code(module: str, source: str) -> Code:
    return Code(sha256(source.encode()).hexdigest(), module, f"{module}.py", source)
