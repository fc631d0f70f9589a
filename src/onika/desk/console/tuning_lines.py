"""Console commands that alter a living task: rate, reinit, swap, get, set, answer (requirements A04, A10, A13, X15)."""

from pathlib import Path

from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.site_library import SiteLibrary
from onika.desk.console.task_lines import missing, positive
from onika.wire import live, request
from onika.words.argument import join
from onika.words.reason import Reason

Words = tuple[str, ...]


def rate(session: ConsoleSession, words: Words) -> Faults:
    """Another rate, while the task runs."""
    subsystem, name = session.address(words[0])
    hz = positive(words[1])
    if hz is None:
        return session.no(Reason.of("console.rate", word=words[1]))
    return missing(session, subsystem, (name,)) or session.order(live.Change(subsystem, rates=((name, hz),)))


def reinit(session: ConsoleSession, words: Words) -> Faults:
    """Initialise a task anew, with another LOCAL line where one is given."""
    subsystem, name = session.address(words[0])
    faults = missing(session, subsystem, (name,))
    if faults or len(words) == 1:
        return faults or session.order(live.Reinit(subsystem, name))
    key, values = words[1], words[2:]
    if not values:
        return session.no(Reason.of("console.local_words", key=key))
    local = dict(session.tasks(subsystem)[name].task.local) | {key: values}
    return session.order(live.Reinit(subsystem, name, tuple(local.items())))


def swap(session: ConsoleSession, words: Words) -> Faults:
    """Exchange the code of a living task: for what its file holds now, or for another file."""
    subsystem, name = session.address(words[0])
    faults = missing(session, subsystem, (name,))
    if faults:
        return faults
    path = Path(words[1]) if len(words) > 1 else code_file(session, subsystem, name)
    if path is None:
        module = session.tasks(subsystem)[name].task.module
        return session.no(Reason.of("console.no_code", module=module))
    return exchange(session, subsystem, name, path)


def exchange(session: ConsoleSession, subsystem: str, name: str, path: Path) -> Faults:
    """Exchange the code of a living task for what a file holds now."""
    module = session.tasks(subsystem)[name].task.module
    code, faults = SiteLibrary(session.site, session.place).code(module, path)
    if code is None:
        return faults
    return session.order(live.Swap(subsystem, name, code))


def code_file(session: ConsoleSession, subsystem: str, name: str) -> Path | None:
    """The file that a living task's code comes from, as far as there is one on the search path."""
    record, _ = session.site.task(name)
    if record is not None:
        return session.site.code_file(record.task)
    module = session.tasks(subsystem)[name].task.module
    return next((path for base in session.site.directories if (path := base.code_file(module)).is_file()), None)


def get(session: ConsoleSession, words: Words) -> Faults:
    """Ask a module for something by name."""
    subsystem, name = session.address(words[0])
    return missing(session, subsystem, (name,)) or _value(session, words[1], live.Get(subsystem, name, words[1]))


def put(session: ConsoleSession, words: Words) -> Faults:
    """Tell a module a new value of something by name."""
    subsystem, name = session.address(words[0])
    message = live.Set(subsystem, name, words[1], words[2])
    return missing(session, subsystem, (name,)) or _value(session, words[1], message)


def write(session: ConsoleSession, words: Words) -> Faults:
    """Write a variable that no task writes, element by element."""
    subsystem, name = session.address(words[0])
    try:
        values = tuple(float(word) for word in words[1:])
    except ValueError:
        return session.no(Reason.of("console.numbers", words=" ".join(words[1:])))
    return session.order(live.Write(subsystem, name, values))


def answer(session: ConsoleSession, words: Words) -> Faults:
    """The argument line that a task asks for."""
    subsystem, name = session.address(words[0])
    if (subsystem, name) not in session.questions:
        asking = tuple("/".join(key) for key in session.questions)
        if asking:
            return session.no(Reason.of("console.other_tasks_ask", asking=asking, word=words[0]))
        return session.no(Reason.of("console.no_task_asks", word=words[0]))
    text = words[1] if len(words) > 1 else defaults(session, subsystem, name)
    line, faults = SiteLibrary(session.site, session.place).arguments(text)
    if faults:
        return faults
    question = session.questions.pop((subsystem, name))
    faults = session.order(request.Reply(subsystem, name, line))
    if faults:
        session.questions.setdefault((subsystem, name), question)
        return faults
    session.hear()
    return ()


def defaults(session: ConsoleSession, subsystem: str, name: str) -> str:
    """The line of all defaults of what is asked for; empty where one has none."""
    items = session.questions[subsystem, name].items
    if any(item.default is None for item in items):
        return ""
    return join(str(value) for item in items for value in item.default or ())


def _value(session: ConsoleSession, name: str, message: request.Request) -> Faults:
    reply = session.ask(message)
    if isinstance(reply, request.Refused):
        return session.no(Reason.of("console.module_refused", reason=reply.reason))
    if isinstance(reply, live.Value) and reply.value is not None:
        session.say(Reason.plain(f"{name} = {reply.value}"))
    return ()
