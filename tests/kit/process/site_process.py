"""A site as a process, with a list of what it launches."""

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

from onika.link.token import digest

LIST = """VERSION 2.0

LAUNCH arm
WORLD boxes
ROBOT arm_left
TIME virtual
CODE yes

LAUNCH crane
WORLD crane

EOF
"""
USERS = {"ann": "operator", "bob": "operator", "eve": "viewer", "kim": "owner", "pat": "programmer"}
ONIKA = Path(sys.executable).with_name("onika")


class SiteProcess:
    """It listens on loopback; the token of each user is his name."""

    def __init__(self, folder: Path, name: str = "cmu", listed: str = LIST, more: tuple[str, ...] = ()) -> None:
        folder.mkdir(exist_ok=True)
        self.list, self.users, self.state = folder / "list", folder / "users", folder / "state"
        self.list.write_text(listed)
        self.users.write_text("".join(f"{user} {role} {digest(user)}\n" for user, role in USERS.items()))
        self.name, self.more = name, more
        self.environment = os.environ | {"XDG_STATE_HOME": str(self.state)}
        self.process = self.started()
        line = self.process.stdout.readline() if self.process.stdout is not None else ""
        match = re.search(r"listens on ([^\s,]+)", line)
        assert match is not None, line
        self.place = match[1]

    def started(self) -> "subprocess.Popen[str]":
        words = [str(ONIKA), "site", "serve", str(self.list), "--name", self.name, "--listen", "127.0.0.1:0"]
        words += ["--users", str(self.users), "--no-fifo", "--no-black-box", *self.more]
        return subprocess.Popen(
            words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=self.environment
        )

    def end(self) -> int:
        """As systemd ends it."""
        self.process.send_signal(signal.SIGTERM)
        code = self.process.wait(20)
        if self.process.stdout is not None:
            self.process.stdout.close()
        return code
