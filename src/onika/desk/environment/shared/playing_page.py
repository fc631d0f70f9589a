"""One HTML file around a recorded document: the player, its styles and the run; nothing in it is fetched (X21).

A policy in the file itself forbids every connection, whatever stands in the recording.
"""

import base64
from dataclasses import dataclass
from html import escape
from pathlib import Path

POLICY = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; "
    "base-uri 'none'; form-action 'none'"
)
"""What the browser lets the file do: draw. It cannot send anything anywhere."""
_SCRIPT, _STYLES = "player.js", "player.css"


@dataclass(frozen=True, slots=True)
class Player:
    """The player as it was built."""

    script: str
    styles: str

    @classmethod
    def read(cls, folder: Path) -> "Player":
        """The player in the folder of the built page; raises OSError where it was not built."""
        return cls((folder / _SCRIPT).read_text(encoding="utf-8"), (folder / _STYLES).read_text(encoding="utf-8"))

    @property
    def bytes(self) -> int:
        """How much of a file it takes."""
        return len(self.script.encode()) + len(self.styles.encode())


def room_for_document(player: Player, most_bytes: int) -> int:
    """So many bytes the document may have that a file of `most_bytes` comes of it: base64 makes four of three."""
    return max((most_bytes - player.bytes - 4096) * 3 // 4, 0)


def playing_page(name: str, document: bytes, player: Player) -> str:
    """The file; `name` is that of the run."""
    script = player.script.replace("</script", "<\\/script").replace("<!--", "<\\!--")
    styles = player.styles.replace("</style", "<\\/style")
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8" />\n'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}" />\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1" />\n'
        f'<title>{escape(name)} – Onika</title>\n<link rel="icon" href="data:," />\n'
        f'<style>{styles}</style>\n</head>\n<body>\n<div id="app"></div>\n'
        f'<script type="text/plain" id="run">{base64.b64encode(document).decode()}</script>\n'
        f'<script type="module">{script}</script>\n</body>\n</html>\n'
    )
