"""What modules declare, for whoever draws or checks them; nothing lives for it."""

from onika.host.loading.module_questions import ModuleQuestions
from onika.wire import live
from onika.wire.plan import Code
from onika.words.fault import Fault


def describe(codes: tuple[Code, ...], loading: ModuleQuestions) -> live.Described:
    """The sheets of modules, and in words why others cannot be read."""
    loading.expect(codes)
    answers = {code.digest: loading.sheet(code) for code in codes}
    sheets = {digest: answer for digest, answer in answers.items() if not isinstance(answer, Fault)}
    return live.Described(
        sheets, {digest: answer.sentence for digest, answer in answers.items() if isinstance(answer, Fault)}
    )
