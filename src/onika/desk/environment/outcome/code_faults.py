"""What is wrong with the code of tasks that stand on a canvas: told with its line and the way there (R-C05, R-C31).

The compiler looks through a file without executing it, also where no runtime is there; what a runtime finds out
when it executes the module comes from there.
"""

import re
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files import whole
from onika.wire.view import ProblemView, Remedy, ShowSource
from onika.words.reason import Reason

LineFault = tuple[int, Reason]
"""The line of the code, 0 for the whole, and what is wrong there."""

_FAULT = "words.fault"
_LINE = re.compile(r".*:(\d+)\Z", re.DOTALL)


def compiled(text: str, name: str) -> tuple[LineFault | None, tuple[LineFault, ...]]:
    """What keeps a text from being code, and where nothing does what the compiler warns of; nothing is executed."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            compile(text, name, "exec", dont_inherit=True)
        except SyntaxError as error:
            return (error.lineno or 0, Reason.plain(error.msg)), ()
        except (ValueError, RecursionError, MemoryError) as error:  # bytes of nothing; nested without end
            return (0, Reason.plain(str(error)) or Reason.of("run.code_nested")), ()
    return None, tuple((message.lineno, Reason.plain(str(message.message))) for message in caught)


def at_line(why: Reason) -> LineFault:
    """What a runtime says of code, at its line where it says one."""
    if why.key != _FAULT:
        return 0, why
    line, reason = _LINE.match(str(why.args["place"])), why.args["reason"]
    return int(line[1]) if line else 0, reason if isinstance(reason, Reason) else why


def looked_through(model: Model) -> Model:
    """With the code of all tasks that stand on a canvas looked through, where it was not since it was written."""
    files = {path for document in model.documents.values() for path in _code_files(document, model)}
    lacking = [path for path in files if str(path) not in model.code_faults]
    if not lacking:
        return model
    return replace(model, code_faults={**model.code_faults, **{str(path): _fault_in(path) for path in lacking}})


def rewritten(model: Model, paths: set[Path]) -> Model:
    """With these files to be looked through again."""
    kept = {path: fault for path, fault in model.code_faults.items() if Path(path) not in paths}
    return model if len(kept) == len(model.code_faults) else replace(model, code_faults=kept)


def code_problems(
    document: Document, libraries: OpenLibraries, code_faults: Mapping[str, LineFault | None]
) -> dict[str, ProblemView]:
    """The tasks of a document whose code cannot be used, one problem each, with the line in its source."""
    return dict(_problems(document, libraries, code_faults))


def _problems(
    document: Document, libraries: OpenLibraries, code_faults: Mapping[str, LineFault | None]
) -> Iterator[tuple[str, ProblemView]]:
    for name in document.content.names:
        path = libraries.code_file(name) if name in libraries.tasks else None
        fault = _fault_of(name, str(path), libraries, code_faults) if path is not None else None
        if fault is None:
            continue
        line, why = fault
        key = "run.code_wrong_at" if line else "run.code_wrong"
        reason = Reason.of(key, task=name, path=str(path), line=line, why=why)
        look = ShowSource(name, line)
        yield f"code {name}", ProblemView(reason, "fault", look, (Remedy(Reason.of("run.source"), show=look),))


def _fault_of(
    name: str, path: str, libraries: OpenLibraries, code_faults: Mapping[str, LineFault | None]
) -> LineFault | None:
    """What the compiler says, else what a runtime has said."""
    fault, unread = code_faults.get(path), libraries.unread.get(libraries.tasks[name].module)
    return fault if fault is not None or unread is None else at_line(unread)


def _code_files(document: Document, model: Model) -> Iterator[Path]:
    libraries = model.libraries_of(document)
    for name in document.content.names:
        path = libraries.code_file(name) if name in libraries.tasks else None
        if path is not None:
            yield path


def _fault_in(path: Path) -> LineFault | None:
    """Of a file that cannot be read a runtime says why."""
    text, _ = whole.read(path)
    return compiled(text[0], path.name)[0] if text is not None else None
