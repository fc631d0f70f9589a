"""A session of a study is readied and ended: every subject has a home of its own, so nothing is lost (§E.1; H09).

All that Onika keeps for a user, diary, preferences, recovery and programs, lies in the home of its user, and so does
what the browser of its window keeps. A session is such a home, empty at first: what the subject before has left lies in
another one, untouched; its log is put away where the report reads it.
"""

import fcntl
import shutil
from dataclasses import dataclass, replace
from pathlib import Path

from onika.files import text as texts
from onika.study import table
from onika.study.folder import LOGS, SUBJECTS
from onika.words.reason import Reason

SESSIONS = "sessions"
VARIANTS = ("pictures", "both", "words")
_PROGRAMS = Path("programs", "appl")
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


def planned(study: Path, subject: str, variant: str = "") -> Session | Reason:
    """The session that `prepare` would ready, or why it would not; nothing is touched. Raises OSError."""
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
    if opened := _opened(study):
        return Reason.of("study.session_open", subject=opened)
    return Session(subject, variant or listed, home.absolute())


def prepare(study: Path, subject: str, variant: str = "") -> Session | Reason:
    """Ready a session; why not. `variant` is that of the table of the study where none is given. Raises OSError."""
    session = planned(study, subject, variant)
    if isinstance(session, Reason):
        return session
    put_away = _put_away(study)
    if isinstance(put_away, Reason):
        return put_away
    (session.home / _PROGRAMS).mkdir(parents=True)
    return replace(session, put_away=put_away)


def end(study: Path, subject: str) -> tuple[Path, ...] | Reason:
    """End a session: its logs stand where the report reads them, its home stays, but for what its browser kept.

    Refused while its page is open: its log is not whole. Where nothing was done in it, as its page never came up, it
    is taken back: its home goes, and the subject can have a session still. Raises OSError.
    """
    if wrong := _wrong_name(subject):
        return wrong
    home = study / SESSIONS / subject
    if _is_open(home):
        return Reason.of("study.session_open", subject=subject)
    diary = sorted((home / _DIARY).glob("*.log"))
    if not diary:
        return _without_diary(home, subject)
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


def _without_diary(home: Path, subject: str) -> Reason:
    """Why there is nothing to put away; a home in which nothing was made is removed."""
    diary = str(home / _DIARY)
    if not home.is_dir():
        return Reason.of("study.no_diary", subject=subject, path=diary)
    if any(path.is_file() for path in (home / _PROGRAMS).parent.rglob("*")):
        return Reason.of("study.programs_alone", subject=subject, path=diary)
    shutil.rmtree(home)
    return Reason.of("study.taken_back", subject=subject)


def _put_away(study: Path) -> tuple[str, ...] | Reason:
    """The logs of all sessions that were used and not ended stand where the report reads them; why not, if so."""
    left = [home for home in _homes(study) if any((home / _DIARY).glob("*.log")) and not _logs_of(study, home.name)]
    for home in left:
        ended = end(study, home.name)
        if isinstance(ended, Reason):
            return ended
    return tuple(home.name for home in left)


def _homes(study: Path) -> list[Path]:
    return sorted((study / SESSIONS).glob("*")) if (study / SESSIONS).is_dir() else []


def _opened(study: Path) -> str:
    """A subject whose page is open; empty: none is."""
    return next((home.name for home in _homes(study) if _is_open(home)), "")


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
