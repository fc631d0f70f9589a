"""What modules declare, for whoever draws or checks them; nothing lives for it."""

from onika.host.loading.module_questions import ModuleQuestions
from onika.host.loading.plan_form import wrong_code
from onika.wire import live
from onika.wire.plan import Code
from onika.words.fault import Fault


def describe(codes: tuple[Code, ...], loading: ModuleQuestions) -> live.Described:
    """The sheets of modules, and in words why others cannot be read."""
    malformed = {code.digest: faults[0] for code in codes if (faults := wrong_code([code]))}
    sound = tuple(code for code in codes if code.digest not in malformed)
    loading.expect(sound)
    answers = malformed | {code.digest: loading.sheet(code) for code in sound}
    sheets = {digest: answer for digest, answer in answers.items() if not isinstance(answer, Fault)}
    return live.Described(
        sheets, {digest: answer.sentence for digest, answer in answers.items() if isinstance(answer, Fault)}
    )
