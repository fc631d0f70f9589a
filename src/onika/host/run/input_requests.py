"""Questions of tasks in a run: answered by what the run was given, else by whoever is there, else the run ends."""

from collections.abc import Callable

from onika.runtime import news
from onika.wire import event
from onika.wire.request import Begin

Tell = Callable[[event.Event], None]


class Questions:
    """Law 25: a module never blocks, it asks. `answer` gives a task its line, `abort` ends the run with a cause."""

    def __init__(
        self, begin: Begin, tell: Tell, answer: Callable[[str, str, str], None], abort: Callable[[str], None]
    ) -> None:
        self._begin = begin
        self._tell = tell
        self._answer = answer
        self._abort = abort
        self._answered: set[str] = set()
        self.told: dict[tuple[str, str], event.Asked] = {}
        """What each task of a subsystem has asked last."""

    def ask(self, heard: news.Asked, at_s: float) -> None:
        """A task asks."""
        given = {name: values for task, name, values in self._begin.answers if task == heard.task}
        names = [one.name for one in heard.items]
        strangers = sorted(given.keys() - set(names))
        if strangers:
            self._abort(
                f"task {heard.task} asks for {', '.join(names)}, and an answer is given for {', '.join(strangers)}"
            )
        elif given and set(names) == given.keys() and heard.task not in self._answered:
            self._answered.add(heard.task)
            self._answer(heard.subsystem, heard.task, " ".join(given[name] for name in names))
        elif self._begin.may_ask:
            items = tuple(event.Item(*(getattr(one, name) for name in one.__struct_fields__)) for one in heard.items)
            told = event.Asked(heard.subsystem, heard.task, heard.reason, items, at_s)
            self.told[heard.subsystem, heard.task] = told
            self._tell(told)
        else:
            wanted = ", ".join(f"{heard.task}.{one.name}" for one in heard.items)
            said_wrong = f" ({heard.reason})" if heard.reason else ""
            self._abort(f"task {heard.task} asks for {wanted}{said_wrong} and nobody is there to answer")
