"""Copies of the user's own: what is shipped is never written, a copy that stands before it is (requirement B07).

The copy has the name of the shipped file, in the user's own base directory, which comes first on the search path.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from onika.files import appl, conf, onk, rmod, text, whole
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import put
from onika.store.replaced_texts import ReplacedTexts
from onika.store.shipped import is_shipped, not_written
from onika.store.site import Site
from onika.words.fault import Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason

_ENDINGS = {"module": (".py", rmod.ENDING), "conf": (conf.ENDING,), "dict": (onk.ENDING,), "appl": (appl.ENDING,)}


@dataclass(frozen=True, slots=True)
class OwnCopy:
    """A file of the user's own and the shipped one before which it stands."""

    own: Path
    shipped: Path

    @property
    def laboratory(self) -> str:
        """The name of the base directory of the shipped one."""
        return self.shipped.parent.parent.name

    def texts(self) -> tuple[str, str] | Refusal:
        """What the user's own holds and what the shipped one holds."""
        own, shipped = _text(self.own), _text(self.shipped)
        if isinstance(own, Refusal):
            return own
        return shipped if isinstance(shipped, Refusal) else (own, shipped)


def saving_place(base: Path, site: Site) -> BaseDirectory | Refusal:
    """The base directory in which a file of `base` is saved: that one, or where it is shipped the user's own."""
    if not is_shipped(base):
        return BaseDirectory(base)
    if site.own is None:
        return Refusal(not_written(base), (whole.ELSEWHERE,))
    return BaseDirectory(site.own)


def own_copies(site: Site) -> tuple[OwnCopy, ...]:
    """All files on the search path that stand before shipped ones, in order."""
    copies = []
    for base in site.directories:
        if not is_shipped(base.path):
            files = (path for folder in _ENDINGS for path in _files(base.path / folder, _ENDINGS[folder]))
            copies += [copy for path in files if (copy := own_copy(path, site))]
    return tuple(copies)


def own_copy(path: Path, site: Site) -> OwnCopy | None:
    """A file of the search path with the shipped one before which it stands; None where it stands before none."""
    folder, bases = path.parent.name, [base.path for base in site.directories]
    home = path.parent.parent
    if home not in bases or is_shipped(home) or path.suffix not in _ENDINGS.get(folder, ()) or not path.is_file():
        return None
    later = bases[bases.index(home) + 1 :]
    twins = ((base, base / folder / path.name) for base in later)  # few are there; to ask who brought one is slow
    shipped = next((twin for base, twin in twins if twin.is_file() and is_shipped(base)), None)
    return OwnCopy(path, shipped) if shipped else None


def copied_with_tasks(code: Path, content: str, tasks: Iterable[Task], site: Site) -> tuple[Path, ...] | Refusal:
    """The changed code of a shipped module in a copy, with copies of the `.rmod` of its tasks, beside which it counts.

    The paths of all that is new. Refused where one of them cannot be written; then none is there.
    """
    home, target = BaseDirectory(code.parent.parent), saving_place(code.parent.parent, site)
    if isinstance(target, Refusal):
        return target
    files = {target.code_file(code.stem): content}
    for task in tasks:
        record, copy = _text(home.task_file(task.name)), target.task_file(task.name)
        if isinstance(record, Refusal):
            return record
        if not copy.exists():
            files[copy] = record
    return _written(files)


def copied_with_code(
    record: Path, content: str, task: Task, code: Path | None, site: Site
) -> tuple[Path, ...] | Refusal:
    """The changed `.rmod` of a shipped task in a copy; its code beside it where else another's would count."""
    target = saving_place(record.parent.parent, site)
    if isinstance(target, Refusal):
        return target
    files = {target.task_file(task.name): content}
    bases = (target, *site.directories)
    counting = next((path for base in bases if (path := base.code_file(task.module)).is_file()), None)
    if code is not None and counting != code:
        source = _text(code)
        if isinstance(source, Refusal):
            return source
        files[target.code_file(task.module)] = source
    return _written(files)


def gone_back(copy: OwnCopy, site: Site, replaced: ReplacedTexts, moment_s: float) -> tuple[Path, ...] | Refusal:
    """Go back to the shipped file: what the copy held is kept among what was replaced, and the copy is gone.

    Of a module's code the copies of its tasks that say what the shipped ones say go with it; a task whose code is the
    user's own too keeps its file, which says what the shipped one says. The paths of all that has changed.
    """
    both = copy.texts()
    if isinstance(both, Refusal):
        return both
    own, shipped = both
    kept = replaced.keep(copy.own, own, moment_s)
    if kept is not None:
        return kept
    base = BaseDirectory(copy.own.parent.parent)
    if copy.own.suffix == rmod.ENDING and _has_own_code(base, copy.shipped, shipped):
        written = whole.write(copy.own, shipped, whole.stamp(own))
        return written if isinstance(written, Refusal) else (copy.own,)
    gone = [copy.own]
    if copy.own.suffix == ".py":
        gone += [file for file in _companions(copy.own.stem, base, site) if _is_as_shipped(file, site)]
    try:
        for path in gone:
            path.unlink(missing_ok=True)
    except OSError as error:
        return Refusal(Reason.of("files.not_savable", path=str(copy.own), why=system_reason(error)))
    return tuple(gone)


def _has_own_code(base: BaseDirectory, shipped: Path, content: str) -> bool:
    """Whether the code of a shipped task is a copy in this base directory, beside which its file has to stand."""
    record, _ = rmod.read(content, shipped.stem, str(shipped))
    if record is None:
        return False
    module = record.task.module
    return base.code_file(module).is_file() and BaseDirectory(shipped.parent.parent).code_file(module).is_file()


def _companions(module: str, base: BaseDirectory, site: Site) -> list[Path]:
    """The files of the tasks of a module here that stand before shipped ones."""
    files = []
    for name in base.tasks:
        record, _ = base.task(name)
        if record is not None and record.task.module == module and own_copy(base.task_file(name), site):
            files.append(base.task_file(name))
    return files


def _is_as_shipped(path: Path, site: Site) -> bool:
    copy = own_copy(path, site)
    both = copy.texts() if copy else None
    return isinstance(both, tuple) and both[0] == both[1]


def _written(files: dict[Path, str]) -> tuple[Path, ...] | Refusal:
    """New files, all or none; where one is there already, none is written."""
    done: list[Path] = []
    for path, content in files.items():
        try:
            written = put(path, content, content, whole.ABSENT)
        except ValueError:  # no text that UTF-8 can hold
            written = Refusal(Reason.of("store.text_not_utf8"))
        if isinstance(written, Refusal):
            for made in done:
                made.unlink(missing_ok=True)
            return written
        done.append(path)
    return tuple(done)


def _text(path: Path) -> str | Refusal:
    content, faults = text.load(path, str(path))
    if content is None:
        return Refusal(faults[0].reason)
    return content


def _files(folder: Path, endings: tuple[str, ...]) -> list[Path]:
    try:
        return sorted(path for path in folder.iterdir() if path.suffix in endings and path.name[0] != ".")
    except OSError:
        return []
