"""What goes into a report of a run for an issue: enough to see why it stopped, and nothing that is secret (X21)."""

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata
from io import BytesIO
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile

from onika import __version__
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.run.machine import features
from onika.desk.run.recording_digest import digest_lines
from onika.record.homeless_copy import homeless_copy
from onika.record.reader import Reader
from onika.store.site import Site
from onika.words.homeless import homeless
from onika.words.reason import Reason

_BESIDE = ("mujoco", "numpy", "msgspec", "mcap", "ruckig", "rich", "starlette", "uvicorn", "websockets")
_FOLDERS = ("module", "conf", "dict", "appl")
_PACKED = ".mcap"


@dataclass(frozen=True, slots=True)
class ReportPart:
    """A file of the report; `about` says what it is."""

    name: str
    content: bytes
    about: Reason


def report_parts(subject: ReviewedRun, site: Site, home: str = "") -> tuple[ReportPart, ...]:
    """All of a report, before anything is written; raises what reading a recording raises."""
    why = "\n".join(str(line) for line in digest_lines(subject.review))
    parts = [
        _text("why.txt", why, "desk.report_why", home),
        _text("machine.txt", "\n".join(_machine()), "desk.report_machine", home),
        _text("libraries.txt", "\n".join(_libraries(subject, site)), "desk.report_libraries", home),
        *_program(subject, site, home),
    ]
    reader, copy = Reader(subject.path), BytesIO()
    try:
        homeless_copy(reader, copy, home)
    finally:
        reader.close()
    parts.append(ReportPart(f"recording{_PACKED}", copy.getvalue(), Reason.of("desk.report_recording")))
    return tuple(parts)


def write_report(path: Path, parts: tuple[ReportPart, ...]) -> None:
    """Write them as one ZIP file; raises OSError."""
    with ZipFile(path, "w") as bundle:
        for part in parts:
            bundle.writestr(part.name, part.content, ZIP_STORED if part.name.endswith(_PACKED) else ZIP_DEFLATED)


def _text(name: str, text: str, about: str, home: str) -> ReportPart:
    return ReportPart(name, f"{homeless(text, home)}\n".encode(), Reason.of(about))


def _machine() -> Iterator[str]:
    yield f"onika {__version__}"
    for feature in features():
        yield f"{feature.name}: {feature.actual}"
    for name in _BESIDE:
        try:
            yield f"{name} {metadata.version(name)}"
        except metadata.PackageNotFoundError:
            yield f"{name} -"


def _libraries(subject: ReviewedRun, site: Site) -> Iterator[str]:
    """Modules as they were in the run, then base directories as they are now."""
    for code in subject.review.run.prepare.plan.code:
        yield f"{code.digest}  {code.module}  {code.path}"
    for base in site.directories:
        yield f"{_digest(base.path)}  {base.path}"


def _digest(folder: Path) -> str:
    """SHA-256 of the names and contents of a base directory's files."""
    digest = hashlib.sha256()
    for path in sorted(path for name in _FOLDERS for path in (folder / name).glob("*.*") if path.is_file()):
        digest.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def _program(subject: ReviewedRun, site: Site, home: str) -> Iterator[ReportPart]:
    """The file of the application, where the site has it."""
    name = subject.view.name
    path = None if subject.review.run.is_by_hand else site.application_file(Path(name).name)
    if path is not None:
        yield _text(f"program/{path.name}", path.read_text(errors="replace"), "desk.report_program", home)
