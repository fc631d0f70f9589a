"""Opens connections to a runtime that it first starts on another machine, all through one ssh session (A15).

The ssh of this machine is used, and so the user's own configuration, keys, agent and known hosts. It never asks: what
it would ask has to be settled by hand once. The runtime listens on its own machine only; the way there is a socket of
this one, which ssh forwards. When the session ends, so does the runtime, unless it was to stay.
"""

import os
import select
import subprocess
import tempfile
import threading
from pathlib import Path
from time import monotonic

from onika.link.address import Address
from onika.link.channel import Channel
from onika.link.child.output_tail import OutputTail
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.ssh_address import SshAddress
from onika.link.websocket import WebSocketCarrier
from onika.link.websocket_opening import WebSocketOpening
from onika.wire.hand_over import HandOver, hand_over_in
from onika.words.reason import Reason
from onika.words.system_error import system_reason

START_S = 30.0
"""How long it may take from the call of ssh until the runtime is there."""
_FORWARD_S = 10.0
_END_S = 5.0
_LONGEST_LINE = 64 * 1024
_OF_SSH, _NO_ONIKA = 255, (126, 127)
"""What ssh ends with where it failed itself, and a shell that does not find a command, or may not carry it out."""
_OPTIONS = {
    "BatchMode": "yes",
    "ControlMaster": "yes",
    "ControlPersist": "no",
    "ServerAliveInterval": "1",
    "ServerAliveCountMax": "5",
    "StreamLocalBindMask": "0177",
    "ForwardAgent": "no",
    "ForwardX11": "no",
}


class SshOpening:
    """One ssh session, begun with the first connection that is opened; more than one thread may open."""

    def __init__(self, address: SshAddress, program: str = "ssh") -> None:
        self.address = address
        self._program = program
        self._lock = threading.Lock()
        self._session: _SshSession | None = None
        self._is_closed = False

    def __call__(self, channel: Channel) -> WebSocketCarrier:
        """Open a connection for a channel; raises LinkLost."""
        return self._opening()(channel)

    def close(self) -> None:
        """End the session."""
        with self._lock:
            self._is_closed = True
            if self._session is not None:
                self._session.close()

    def _opening(self) -> WebSocketOpening:
        with self._lock:
            session = self._session
            if session is not None and session.is_alive:
                return session.opening
            if self._is_closed or (session is not None and not self.address.stays):
                raise LinkLost(LossCause.OVER, Reason.of("link.ssh_ended", address=str(self.address)))
            if session is not None:
                session.close()
            self._session = _SshSession(self.address, self._program)
            return self._session.opening


class _SshSession:
    """A process of ssh, what it forwards, and how the runtime behind it is reached; raises LinkLost."""

    def __init__(self, address: SshAddress, program: str) -> None:
        self._address = address
        self._program = program
        self._folder = tempfile.TemporaryDirectory(prefix="onika-ssh-")
        self._input, self._output = _Pipe(), _Pipe()
        complaints = _Pipe()
        self._complaints = OutputTail(complaints.reader)
        try:
            self._process = self._begun(complaints.writer)
        except BaseException:
            self._folder.cleanup()
            self._input.close()
            self._output.close()
            raise
        finally:
            os.close(complaints.writer)
        try:
            hand_over = self._handed_over()
            self._forward(hand_over.port)
        except BaseException:
            self.close()
            raise
        there = Address("127.0.0.1", hand_over.port, is_private=False)
        self.opening = WebSocketOpening(there, hand_over.token, tunnel=self._tunnel)

    @property
    def is_alive(self) -> bool:
        """Whether ssh runs."""
        return self._process.poll() is None

    def close(self) -> None:
        """End it. A runtime that does not stay sees the end of its input, and is waited for; it cannot hold this up."""
        self._input.close()
        if self._address.stays:
            self._process.terminate()
        try:
            self._process.wait(_END_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._output.close()
        self._complaints.close()
        self._folder.cleanup()

    # Inner

    @property
    def _control(self) -> str:
        return f"{self._folder.name}/control"

    @property
    def _tunnel(self) -> Path:
        return Path(self._folder.name) / "runtime"

    def _begun(self, complaints: int) -> "subprocess.Popen[bytes]":
        options = [word for name, value in _OPTIONS.items() for word in ("-o", f"{name}={value}")]
        words = [self._program, "-T", "-S", self._control, *options, *self._address.place, self._address.command]
        try:
            return subprocess.Popen(  # noqa: S603  no shell here, and every word was judged
                words,
                stdin=self._input.reader,
                stdout=self._output.writer,
                stderr=complaints,
                start_new_session=True,  # Ctrl-C is for this program, which stops what moves before it ends
            )
        except OSError as fault:
            no_ssh = Reason.of("link.no_ssh", program=self._program, why=system_reason(fault))
            raise LinkLost(LossCause.UNREACHABLE, no_ssh) from None
        finally:
            self._input.close_reader()
            self._output.close_writer()

    def _handed_over(self) -> HandOver:
        """The line that the runtime's machine says, whatever else it says before."""
        output, until, heard = self._output.reader, monotonic() + START_S, b""
        while select.select([output], [], [], max(0.0, until - monotonic()))[0]:
            data = os.read(output, 4096)
            if not data:
                raise self._why_ended()
            *lines, heard = (heard + data).split(b"\n")
            for line in lines:
                hand_over = hand_over_in(line.decode("utf-8", "replace"))
                if hand_over is not None:
                    return hand_over
            heard = heard[-_LONGEST_LINE:]
        late = Reason.of("link.ssh_late", address=str(self._address), seconds=START_S)
        raise LinkLost(LossCause.TIMEOUT, late)

    def _why_ended(self) -> LinkLost:
        try:
            code = self._process.wait(_END_S)
        except subprocess.TimeoutExpired:
            code = 0
        self._complaints.close()
        said = Reason.plain(self._complaints.text().strip()[-2000:])
        where = str(self._address)
        if code == _OF_SSH:
            place = " ".join(word for word in self._address.place if word != "--")
            return LinkLost(LossCause.UNREACHABLE, Reason.of("link.ssh_failed", address=where, why=said, place=place))
        if code in _NO_ONIKA:
            return LinkLost(LossCause.REFUSED, Reason.of("link.ssh_no_onika", address=where, why=said))
        return LinkLost(LossCause.REFUSED, Reason.of("link.ssh_no_runtime", address=where, code=code, why=said))

    def _forward(self, port: int) -> None:
        """Let a socket of this machine, which only this user may use, lead to a port of that one."""
        way = f"{self._tunnel}:127.0.0.1:{port}"
        words = [self._program, "-S", self._control, "-O", "forward", "-L", way, *self._address.place]
        try:
            done = subprocess.run(  # noqa: S603  as above
                words, stdin=subprocess.DEVNULL, capture_output=True, timeout=_FORWARD_S, check=False
            )
        except subprocess.TimeoutExpired:
            late = Reason.of("link.ssh_late", address=str(self._address), seconds=_FORWARD_S)
            raise LinkLost(LossCause.TIMEOUT, late) from None
        if done.returncode:
            why = Reason.plain(done.stderr.decode("utf-8", "replace").strip()[-2000:])
            raise LinkLost(LossCause.REFUSED, Reason.of("link.ssh_no_tunnel", address=str(self._address), why=why))


class _Pipe:
    """Both ends of a pipe, each closed once."""

    def __init__(self) -> None:
        self.reader, self.writer = os.pipe()
        self._open = {self.reader, self.writer}

    def close_reader(self) -> None:
        """Close the end that is read."""
        self._close(self.reader)

    def close_writer(self) -> None:
        """Close the end that is written."""
        self._close(self.writer)

    def close(self) -> None:
        """Close what is open."""
        self._close(self.reader)
        self._close(self.writer)

    def _close(self, descriptor: int) -> None:
        if descriptor in self._open:
            self._open.remove(descriptor)
            os.close(descriptor)
