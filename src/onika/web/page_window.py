"""A window of the page of a given size at a given place, in a browser that keeps nothing of others (H09)."""

import re
import shutil
import subprocess
import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from onika.words.reason import Reason

_BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge")
"""Those that open a page in a window of its own; other browsers put it where they like."""
_WINDOW = re.compile(r"(\d{3,5})x(\d{3,5})(?:\+(\d{1,5})\+(\d{1,5}))?")


@dataclass(frozen=True, slots=True)
class PageWindow:
    """A window: its size and the place of its upper left corner, in pixels of the screen."""

    width: int
    height: int
    left: int = 0
    top: int = 0

    @classmethod
    def read(cls, text: str) -> "PageWindow":
        """A window as `1280x900` or `1280x900+0+0`; raises ValueError for anything else."""
        match = _WINDOW.fullmatch(text)
        if match is None:
            raise ValueError(Reason.of("cli.window_expected", text=text))
        width, height, left, top = (int(number or 0) for number in match.groups())
        return cls(width, height, left, top)

    def __str__(self) -> str:
        return f"{self.width}x{self.height}+{self.left}+{self.top}"

    def command(self, address: str, profile: Path) -> tuple[str, ...]:
        """How it is opened; empty: no browser is here that could. `profile` is the folder that this browser keeps."""
        path = next(filter(None, map(shutil.which, _BROWSERS)), None)
        if path is None:
            return ()
        return (
            path, f"--app={address}", f"--window-size={self.width},{self.height}",
            f"--window-position={self.left},{self.top}", f"--user-data-dir={profile}",
            "--no-first-run", "--no-default-browser-check",
        )  # fmt: skip

    def open(self, address: str, profile: Path, closed: Callable[[], None] = lambda: None) -> bool:
        """Open it; False where no browser is here that could. `closed` is called, by a thread, when it was closed."""
        command = self.command(address, profile)
        if not command:
            return False
        try:
            browser = subprocess.Popen(  # noqa: S603 - the user's own browser
                command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                start_new_session=True,
            )  # fmt: skip
        except OSError:
            return False

        def watch() -> None:
            browser.wait()  # nothing is left of it when it ends
            closed()

        threading.Thread(target=watch, daemon=True).start()
        return True
