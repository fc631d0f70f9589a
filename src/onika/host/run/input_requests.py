"""Input requests: a task is answered by what the run was given, else by a user, else the run ends (law 25)."""

from collections.abc import Callable

from onika.runtime import news
from onika.wire.request import Begin
from onika.words.reason import Reason


class InputRequests:
    """`answer` gives a task its line, `ask_user` tells sessions, `abort` ends the run with a cause."""

    def __init__(
        self,
        begin: Begin,
        answer: Callable[[str, str, str], None],
        ask_user: Callable[[news.Asked], None],
        abort: Callable[[Reason], None],
    ) -> None:
        self._begin = begin
        self._answer = answer
        self._ask_user = ask_user
        self._abort = abort
        self._answered: set[str] = set()

    def ask(self, question: news.Asked) -> None:
        """A task asks."""
        task = question.task
        given = {name: values for name_of_task, name, values in self._begin.answers if name_of_task == task}
        names = tuple(item.name for item in question.items)
        strangers = tuple(sorted(given.keys() - set(names)))
        if strangers:
            self._abort(Reason.of("host.answer_for_others", task=task, names=names, others=strangers))
        elif given and set(names) == given.keys() and task not in self._answered:
            self._answered.add(task)
            self._answer(question.subsystem, task, " ".join(given[name] for name in names))
        elif self._begin.may_ask:
            self._ask_user(question)
        else:
            self._abort(_nobody_answers(question, tuple(f"{task}.{name}" for name in names)))


def _nobody_answers(question: news.Asked, names: tuple[str, ...]) -> Reason:
    if question.reason:
        return Reason.of("host.nobody_answers_why", task=question.task, names=names, why=question.reason)
    return Reason.of("host.nobody_answers", task=question.task, names=names)
