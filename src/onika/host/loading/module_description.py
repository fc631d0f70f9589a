"""What modules declare, for whoever draws or checks them; nothing lives for it."""

from onika.host.loading.module_questions import Loading
from onika.wire import live
from onika.wire.plan import Code
from onika.words.fault import Fault


def describe(codes: tuple[Code, ...], loading: Loading) -> live.Described:
    """The sheets of modules, and in words why others cannot be read."""
    loading.expect(codes)
    found = {code.digest: loading.sheet(code) for code in codes}
    sheets = {digest: one for digest, one in found.items() if not isinstance(one, Fault)}
    return live.Described(sheets, {digest: str(one) for digest, one in found.items() if isinstance(one, Fault)})
