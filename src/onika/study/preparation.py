"""A session of a study is readied and ended: every subject has a home of its own, so nothing is lost (§E.1; H09).

All that Onika keeps for a user, diary, preferences, recovery and programs, lies in the home of its user, and so does
what the browser of its window keeps. A session is such a home, empty at first: what the subject before has left lies in
another one, untouched; its log is put away where the report reads it.
"""

import fcntl
import shutil
from dataclasses import dataclass
from pathlib import Path

from onika.files import text as texts
from onika.study import table
from onika.study.folder import LOGS, SUBJECTS
from onika.words.reason import Reason

SESSIONS = "sessions"
VARIANTS = ("pictures", "both", "words")
_STATE = Path(".local", "state", "onika")
_DIARY = _STATE / "diary"
_RUNNING = _STATE / "recovery"
"""Whoever has the page open holds a lock in a folder of this one."""
_BROWSER = _STATE / "browser"
_STRANGE = frozenset("/\\\0")
_LONGEST = 60


@dataclass(frozen=True, slots=True)
class Session:
    """The session of a subject: its home, and the variant that it gets; `put_away`: whose logs were not yet."""

    subject: str
    variant: str
    home: Path
    put_away: tuple[str, ...] = ()


def prepare(study: Path, subject: str, variant: str = "") -> Session | Reason:
    """Ready a session; why not. `variant` is that of the table of the study where none is given. Raises OSError."""
    if wrong := _wrong_name(subject):
        return wrong
    listed = _listed(study, subject)
    if not variant and not listed:
        return Reason.of("study.no_variant", subject=subject)
    if variant and listed and variant != listed:
        return Reason.of("study.other_variant", subject=subject, listed=listed, variant=variant)
    home = study / SESSIONS / subject
    if home.exists() or _logs_of(study, subject):
        return Reason.of("study.session_there", subject=subject, path=str(home))
    put_away = _put_away(study)
    if isinstance(put_away, Reason):
        return put_away
    (home / "programs" / "appl").mkdir(parents=True)
    return Session(subject, variant or listed, home.absolute(), put_away)


def end(study: Path, subject: str) -> tuple[Path, ...] | Reason:
    """End a session: its logs stand where the report reads them, its home stays, but for what its browser kept.

    Refused while its page is open: its log is not whole. Raises OSError.
    """
    if wrong := _wrong_name(subject):
        return wrong
    home = study / SESSIONS / subject
    if _is_open(home):
        return Reason.of("study.session_open", subject=subject)
    diary = sorted((home / _DIARY).glob("*.log"))
    if not diary:
        return Reason.of("study.no_diary", subject=subject, path=str(home / _DIARY))
    place = study / LOGS / subject
    if _logs_of(study, subject):
        return Reason.of("study.ended_already", subject=subject, path=str(place))
    place.parent.mkdir(exist_ok=True)
    fresh = place.with_name(f".{subject}.new")
    shutil.rmtree(fresh, ignore_errors=True)  # of an end that was broken off; the diary is still in its home
    fresh.mkdir()
    for path in diary:
        shutil.copy2(path, fresh / path.name)
    fresh.rename(place)
    shutil.rmtree(home / _BROWSER, ignore_errors=True)
    return tuple(place / path.name for path in diary)


def _put_away(study: Path) -> tuple[str, ...] | Reason:
    """The logs of all sessions that were used and not ended stand where the report reads them; why not, if so."""
    homes = sorted((study / SESSIONS).glob("*")) if (study / SESSIONS).is_dir() else []
    left = [home for home in homes if any((home / _DIARY).glob("*.log")) and not _logs_of(study, home.name)]
    opened = next((home.name for home in homes if _is_open(home)), "")
    if opened:
        return Reason.of("study.session_open", subject=opened)
    for home in left:
        ended = end(study, home.name)
        if isinstance(ended, Reason):
            return ended
    return tuple(home.name for home in left)


def _is_open(home: Path) -> bool:
    """Whether somebody has the page of this home open."""
    return any(map(_is_locked, (home / _RUNNING).glob("*/.lock")))


def _is_locked(path: Path) -> bool:
    with path.open("rb") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except OSError:
            return True
    return False


def _wrong_name(subject: str) -> Reason | None:
    """A name has to be that of a folder, and to be told apart."""
    if subject and not subject.startswith(".") and not _STRANGE & set(subject) and subject.isprintable():
        return None
    return Reason.of("study.no_name", text=subject[:_LONGEST])


def _listed(study: Path, subject: str) -> str:
    content, _ = texts.load(study / SUBJECTS, SUBJECTS)
    rows, _ = table.read(content or "", SUBJECTS)
    return next((row.cells.get("group", "") for row in rows if row.subject == subject), "")


def _logs_of(study: Path, subject: str) -> bool:
    """Whether there is a log under this name."""
    places = (study / LOGS / subject, study / LOGS / f"{subject}.log", study / f"{subject}.log", study / subject)
    return any(place.exists() for place in places)
