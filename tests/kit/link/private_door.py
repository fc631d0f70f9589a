"""A server over TLS that has made its certificate itself, and answers every question alike."""

import socket
import ssl
import subprocess
import threading
from contextlib import suppress
from pathlib import Path

_NOBODY = b"HTTP/1.1 404 No\r\nContent-Length: 0\r\n\r\n"


def made_certificate(folder: Path, *names: str) -> tuple[Path, Path]:
    """A certificate for these names (`DNS:…`, `IP:…`) and its key, as files."""
    files = folder / "cert.pem", folder / "key.pem"
    kind = ["-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2", "-subj", "/CN=robot"]
    words = ["openssl", "req", "-x509", *kind, "-addext", f"subjectAltName={','.join(names)}"]
    words += ["-out", str(files[0]), "-keyout", str(files[1])]
    subprocess.run(words, check=True, capture_output=True)
    return files


class PrivateDoor:
    """At `port` of this machine until it is closed; `der` is what it shows."""

    def __init__(self, folder: Path, *names: str, answer: bytes = _NOBODY) -> None:
        certificate, key = made_certificate(folder, *(names or ("IP:127.0.0.1",)))
        self.der = ssl.PEM_cert_to_DER_cert(certificate.read_text())
        self._context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        self._context.load_cert_chain(certificate, key)
        self._answer = answer
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    def close(self) -> None:
        with suppress(OSError):
            self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self._thread.join(10.0)

    def _serve(self) -> None:
        while True:
            try:
                plain, _ = self._listener.accept()
            except OSError:
                return
            with plain, suppress(OSError):
                plain.settimeout(5.0)
                with self._context.wrap_socket(plain, server_side=True) as private:
                    if private.recv(4096):
                        private.sendall(self._answer)
