"""What a site keeps on its machine: by what it is known again, and that nobody else serves it (requirement F06)."""

import fcntl
import os
import secrets
from pathlib import Path
from typing import IO

from onika.files.state.state_directory import make_own
from onika.words.reason import Reason

_LETTERS = 32


class SiteState:
    """The folder of a site, locked as long as this lives; raises OSError where another program serves it already."""

    def __init__(self, folder: Path, site: str) -> None:
        make_own(folder)
        path = folder / f"site-{site}"
        self._file: IO[bytes] = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT, 0o600), "rb+", buffering=0)
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            self.identity = self._known() or self._drawn()
        except BlockingIOError:
            self._file.close()
            raise OSError(Reason.of("site.served_already", site=site)) from None
        except OSError:
            self._file.close()
            raise

    def close(self) -> None:
        """Another program may serve it from now on."""
        self._file.close()

    def _known(self) -> str:
        text = self._file.read(4096).decode("ascii", "replace").strip()
        return text if len(text) == _LETTERS and text.isalnum() else ""

    def _drawn(self) -> str:
        identity = secrets.token_hex(_LETTERS // 2)
        self._file.seek(0)
        self._file.truncate()
        self._file.write(identity.encode() + b"\n")
        return identity
