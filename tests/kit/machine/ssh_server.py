"""A real sshd of its own on this machine, with keys, a place for states, and an `ssh` that knows it as `robot`."""

import os
import select
import shutil
import socket
import subprocess
import sys
from pathlib import Path

_SEARCHED = f"{os.environ.get('PATH', '')}:/usr/sbin"
SSH, SSHD, KEYGEN = (shutil.which(name, path=_SEARCHED) or "" for name in ("ssh", "sshd", "ssh-keygen"))
IS_THERE = bool(SSH and SSHD and KEYGEN)


class SshServer:
    """Lets in whoever uses its `ssh`; what is started there keeps its state in `state`."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.state = folder / "state"
        self.program = _script(folder / "onika", f'exec {Path(sys.executable).with_name("onika")} "$@"')
        self._port = _free_port()
        for name in ("host", "user", "other"):
            subprocess.run([KEYGEN, "-q", "-t", "ed25519", "-N", "", "-f", str(folder / name)], check=True)
        (folder / "bin").mkdir()
        client = self._written("ssh_config", self._client())
        self.ssh = _script(folder / "bin" / "ssh", f'exec {SSH} -F {client} "$@"')
        self.know("host")
        if os.geteuid() == 0:
            Path("/run/sshd").mkdir(exist_ok=True)
        words = [SSHD, "-D", "-e", "-f", str(self._written("sshd_config", self._server()))]
        self._process = subprocess.Popen(words, stderr=subprocess.PIPE)
        self._await()

    def know(self, *keys: str) -> None:
        """From now on the client takes these for the server's; the right one is `host`, `other` is a wrong one."""
        lines = [f"[127.0.0.1]:{self._port} {(self._folder / f'{key}.pub').read_text()}" for key in keys]
        (self._folder / "known_hosts").write_text("".join(lines))

    def environment(self) -> dict[str, str]:
        """Of a program that calls this `ssh`."""
        path = f"{self.ssh.parent}:{os.environ['PATH']}"
        environment = os.environ | {"PATH": path, "XDG_STATE_HOME": str(self._folder / "here")}
        environment.pop("ONIKA_TOKEN", None)
        return environment

    def close(self) -> None:
        """Nobody is let in any more."""
        self._process.terminate()
        self._process.communicate(timeout=10)

    # Inner

    def _written(self, name: str, lines: list[str]) -> Path:
        path = self._folder / name
        path.write_text("\n".join(lines) + "\n")
        return path

    def _server(self) -> list[str]:
        authorized = self._folder / "authorized_keys"
        authorized.write_text((self._folder / "user.pub").read_text())
        sources = os.environ.get("PYTHONPATH", "")
        return [
            f"Port {self._port}", "ListenAddress 127.0.0.1", f"HostKey {self._folder / 'host'}", "PidFile none",
            f"AuthorizedKeysFile {authorized}", "StrictModes no", "UsePAM no", "PasswordAuthentication no",
            "PermitRootLogin yes", f"SetEnv XDG_STATE_HOME={self.state} PYTHONPATH={sources}",
        ]  # fmt: skip

    def _client(self) -> list[str]:
        return [
            "Host robot", "HostName 127.0.0.1", f"Port {self._port}", f"IdentityFile {self._folder / 'user'}",
            f"UserKnownHostsFile {self._folder / 'known_hosts'}", "GlobalKnownHostsFile none", "IdentitiesOnly yes",
        ]  # fmt: skip

    def _await(self) -> None:
        """It says at which ports it listens."""
        said, errors = b"", self._process.stderr
        if errors is None:
            raise TypeError("expected a pipe")
        while b"listening on" not in said:
            if not select.select([errors], [], [], 20.0)[0] or not (data := os.read(errors.fileno(), 4096)):
                raise OSError(f"sshd did not come up: {said.decode(errors='replace')}")
            said += data


def _script(path: Path, line: str) -> Path:
    path.write_text(f"#!/bin/sh\n{line}\n")
    path.chmod(0o755)
    return path


def _free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as server:
        number: int = server.getsockname()[1]
    return number
