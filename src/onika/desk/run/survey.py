"""Checks files: every fault of a base directory, a file, or an application with all it needs (requirement B07)."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

from onika.desk.plan.compile import UNKNOWN, no_code, planned_task, rtpus_of
from onika.desk.plan.module_code import module_code
from onika.desk.plan.placed_puzzle import PlacedPuzzle
from onika.desk.plan.preparation import PreparedRun, prepare_run
from onika.desk.plan.world_causes import with_causes
from onika.desk.plan.world_survey import world_sources
from onika.desk.run.configuration_survey import judged, need_modules, surveyed
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.files import appl, buttons, conf, onk, picture, preferences, rmod, robot, syntax, text, world
from onika.files.puzzles import puzzle
from onika.model.rules.warning import self_fed
from onika.model.syntax import Syntax
from onika.store import module_catalogue
from onika.store.base_directory import BaseDirectory
from onika.store.repeated_names import folded
from onika.store.site import Site
from onika.wire import live, request
from onika.wire.plan import Code, PlannedTask
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place, parted
from onika.words.reason import Reason
from onika.words.system_error import system_reason

_FOLDERS = ("module", "conf", "dict", "appl", "prefs", "world", "robot", "puzzle")

Reader = Callable[[str, str, str], tuple[object, Iterable[Fault]]]
"""Reads what a file holds by its content, its name and its place; the faults come second."""

_READERS: Mapping[str, Reader] = {
    conf.ENDING: conf.read,
    picture.ENDING: picture.read,
    puzzle.ENDING: puzzle.read,
    robot.ENDING: robot.read,
    world.ENDING: world.read,
}
"""By the endings of files."""

_READERS_BY_NAME: Mapping[str, Reader] = {
    syntax.NAME: syntax.read,
    f".{syntax.NAME}": syntax.read,
    preferences.NAME: preferences.read,
    buttons.NAME: buttons.read,
}
"""By their names."""


Note = Callable[[Reason], None]
"""Told what is worth knowing and wrong with nothing."""


def survey(path: Path, site: Site, note: Note = lambda _text: None) -> tuple[list[Path], list[Fault]]:
    """The files that were read below a path (or the one file), and everything that is wrong with them.

    Files are named as `path` is: relative or absolute.
    """
    if not path.exists():
        return _unchecked(path, Reason.of("desk.nothing_there"))
    whole = path.absolute()
    try:
        files_of = _files_of_bases(whole)
    except OSError as error:
        unreadable = Reason.of("desk.directory_unreadable", why=system_reason(error))
        return [], [Fault(Place(str(path)), unreadable, Reason.of("words.left_out"))]
    files = [file for files_of_base in files_of.values() for file in files_of_base]
    if not files and not _is_base_directory(whole):
        return _unchecked(path, Reason.of("desk.nothing_of_ours"))
    notes: list[Reason] = []
    wrong, notes_of_faults = parted(_faults(files_of, site, notes.append))
    named = (fault.sentence for fault in folded(dict.fromkeys(_named(fault, path) for fault in notes_of_faults)))
    for remark in dict.fromkeys((*named, *(_placed(remark, path) for remark in notes))):
        note(remark)
    return [Path(_as_given(str(file), path)) for file in files], sorted(_named(fault, path) for fault in wrong)


def _unchecked(path: Path, reason: Reason) -> tuple[list[Path], list[Fault]]:
    return [], [Fault(Place(str(path)), reason, Reason.of("desk.nothing_checked"))]


def _faults(files_of: Mapping[Path | None, list[Path]], site: Site, note: Note) -> list[Fault]:
    """Everything that is wrong with the files of these base directories, each file by itself and all together."""
    types, syntax_faults = site.syntax()
    faults = list(syntax_faults)
    if types is not None:
        for files in files_of.values():
            for file in files:
                faults += _read(file, types)
    for base, files in files_of.items():
        faults += _judge(files, site.at(base) if base else site, note)
    return faults


def _named(fault: Fault, path: Path) -> Fault:
    place, *because = (Place(_as_given(at.file, path), at.line) for at in (fault.place, *fault.because))
    return replace(fault, place=place, because=tuple(because))


def _placed(note: Reason, path: Path) -> Reason:
    """A note whose file is named as the user wrote the path."""
    if "file" not in note.args:
        return note
    return Reason.of(note.key, **{**note.args, "file": _as_given(str(note.args["file"]), path)})


def _as_given(text: str, path: Path) -> str:
    """A place below `path` as the user wrote that path."""
    whole, rest = str(path.absolute()), text.removeprefix(str(path.absolute()))
    if not text.startswith(whole) or rest[:1] not in ("", "/", ":"):
        return text
    return (str(path) + rest).removeprefix("./")


def _files_of_bases(path: Path) -> dict[Path | None, list[Path]]:
    """The files of a directory and of each base directory in it, by their base directory; of a file, itself."""
    if not path.is_dir():
        return {None: [path]}
    inner = sorted(folder for folder in path.iterdir() if folder.name not in _FOLDERS and _is_base_directory(folder))
    return {base: _files(base) for base in (path, *inner)}


def _is_base_directory(path: Path) -> bool:
    return any((path / name).is_dir() for name in _FOLDERS)


def _files(path: Path) -> list[Path]:
    """What has the name of one of our files, whatever it is: what cannot be read is told when it is."""
    folders = [path / name for name in _FOLDERS if (path / name).is_dir()] or [path]
    return sorted(file for folder in folders for file in folder.iterdir() if _is_ours(file))


def _is_ours(file: Path) -> bool:
    endings = (rmod.ENDING, conf.ENDING, onk.ENDING, appl.ENDING, ".dta", ".py", *module_catalogue.ENDINGS)
    endings += (robot.ENDING, world.ENDING, puzzle.ENDING)
    own = (preferences.NAME, buttons.NAME, f".{syntax.NAME}")
    return (file.name.endswith(endings) and not file.name.startswith(".")) or file.name in own


def _read(file: Path, types: Syntax) -> list[Fault]:
    """The faults of one file by itself."""
    if file.suffix == ".py":
        return []  # looked at together with the tasks that use it
    content, faults = text.load(file, str(file))
    if content is None:
        return list(faults)
    name, place = file.stem, str(file)
    if file.name.endswith(module_catalogue.ENDINGS):
        return list(module_catalogue.read(content, place)[1])
    match file.suffix:
        case rmod.ENDING:
            return _read_task(content, name, place)
        case onk.ENDING:
            return list(onk.read(content, name, place, types)[1])
        case appl.ENDING:
            return list(appl.read(content, name, place, types)[1])
    reader = _READERS_BY_NAME.get(file.name) or _READERS.get(file.suffix)
    if reader is None:
        return [Fault(Place(place), Reason.of("desk.format_unknown"), Reason.of("desk.not_read"))]
    return list(reader(content, name, place)[1])


def _read_task(content: str, name: str, place: str) -> list[Fault]:
    record, faults = rmod.read(content, name, place)
    return [*faults, *(self_fed(record.task, Place(place)) if record else ())]


def _judge(files: list[Path], site: Site, note: Note) -> list[Fault]:
    """What only modules can tell: tasks against their classes, applications against everything."""
    faults: list[Fault] = []
    configurations = surveyed(_with_ending(files, conf.ENDING), site)
    modules = {file.stem: file for file in _with_ending(files, ".py")}
    planned, code = _tasks(_with_ending(files, rmod.ENDING), modules, site, faults)
    applications = [file for file in _with_ending(files, appl.ENDING) if not _is_part(file, site)]
    worlds, world_faults = world_sources(files, site)
    faults += world_faults
    faults += _puzzle_faults(_with_ending(files, puzzle.ENDING), site)
    if not (planned or code or applications or worlds or need_modules(configurations)):
        return faults + judged(configurations, site, _of_none)
    prepared = [prepare_run(str(file), site) for file in applications]
    with LaunchedRuntime(_units(prepared), is_virtual=True) as runtime:
        faults += judged(configurations, site, partial(_described, runtime))
        faults += _asked(runtime, request.Inspect(tuple(planned), tuple(code)), note)
        for world in worlds:  # each by itself: together their meshes may be more than a request holds
            faults += _asked(runtime, request.Inspect((), (), (world,)), note)
        for run in prepared:
            faults += _judged(runtime, run, note)
    return with_causes(faults, site)


def _puzzle_faults(files: list[Path], site: Site) -> list[Fault]:
    """What is wrong with the programs of puzzles."""
    faults: list[Fault] = []
    for file in files:
        base = BaseDirectory(file.absolute().parent.parent)
        record, _ = base.puzzle(file.stem) if file.stem in base.puzzles else (None, ())
        if record is not None:
            faults += PlacedPuzzle(record, base).faults(site)
    return faults


def _units(prepared: Iterable[PreparedRun]) -> tuple[str, ...]:
    """The processing units that the plans name."""
    names = {name for run in prepared if run.plan for name in rtpus_of(run.plan)}
    return tuple(sorted(names)) or ("rt0",)


def _described(runtime: LaunchedRuntime, code: tuple[Code, ...]) -> Mapping[str, ModuleSheet]:
    answer = runtime.ask(live.Describe(code))
    return answer.sheets if isinstance(answer, live.Described) else {}


def _of_none(_code: tuple[Code, ...]) -> Mapping[str, ModuleSheet]:
    return {}


def _with_ending(files: list[Path], ending: str) -> list[Path]:
    return [file for file in files if file.suffix == ending]


def _judged(runtime: LaunchedRuntime, run: PreparedRun, note: Note) -> list[Fault]:
    """What is wrong with an application, by itself and by its modules, and what is worth knowing of it."""
    faults = [*run.notes, *run.faults]
    if run.plan is not None:
        faults += _asked(runtime, request.Prepare(run.plan, run.targets), note)
    return faults


def _is_part(file: Path, site: Site) -> bool:
    """Whether an application has an icon that takes targets: its holes are judged in the applications that use it."""
    types, _ = site.syntax()
    onikon = site.onikon(file.stem, types)[0] if types else None
    kind = types.find(onikon.type) if types and onikon else None
    return kind is not None and kind.is_application and kind.needs_target


def _asked(runtime: LaunchedRuntime, question: request.Request, note: Note) -> list[Fault]:
    answer = runtime.ask(question)
    if isinstance(answer, request.Refused):
        return [Fault(Place("runtime"), answer.reason, Reason.of("desk.not_read"))]
    if not isinstance(answer, request.Prepared):
        return []
    for sentence in answer.notes:
        note(sentence)
    return [text.fault for text in answer.faults]


def _tasks(
    files: list[Path], modules: dict[str, Path], site: Site, faults: list[Fault]
) -> tuple[list[PlannedTask], list[Code]]:
    """Tasks and code, read anew from their own directories; modules that no task uses are looked at too."""
    planned: list[PlannedTask] = []
    code: dict[str, Code] = {}
    homes = set()
    for file in files:
        content, _ = text.load(file, str(file))
        record = None if content is None else rmod.read(content, file.stem, str(file))[0]
        if record is None:
            continue
        own = BaseDirectory(file.absolute().parent.parent)
        path = _code_path(own, record.task.module, site, record.task)
        if path is None:
            faults.append(no_code(record.task.module, str(file)))
            continue
        entry = _code(path, record.task.module, faults)
        if entry is not None:
            code[entry.digest] = entry
            planned.append(planned_task(record.task, UNKNOWN, entry.digest, str(file)))
            homes.add(record.task.module)
    for module in sorted(modules.keys() - homes):
        entry = _code(modules[module], module, faults)
        if entry is not None:
            code.setdefault(entry.digest, entry)
    return planned, list(code.values())


def _code_path(own: BaseDirectory, module: str, site: Site, task: object) -> Path | None:
    beside = own.code_file(module)
    if beside.is_file():
        return beside
    return next((path for base in site.directories if (path := base.code_file(module)).is_file()), None)


def _code(path: Path, module: str, faults: list[Fault]) -> Code | None:
    source, faults_of_file = text.load(path, str(path))
    faults += faults_of_file
    if source is None:
        return None
    return module_code(module, path, source)
