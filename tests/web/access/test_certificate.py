import ssl
import subprocess

import pytest

from onika.web.access.certificate import fingerprint, server_context


@pytest.fixture
def files(tmp_path):
    try:
        words = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"]
        places = ["-subj", "/CN=x", "-out", str(tmp_path / "cert"), "-keyout", str(tmp_path / "key")]
        subprocess.run([*words, *places], check=True, capture_output=True)
    except FileNotFoundError:
        pytest.skip("there is no openssl to make a certificate with")
    return str(tmp_path / "cert"), str(tmp_path / "key")


def test_a_server_speaks_no_tls_older_than_1_2(files):  # R-F10
    assert server_context(*files).minimum_version is ssl.TLSVersion.TLSv1_2


def test_files_that_are_none_are_said(files, tmp_path):  # R-X01
    with pytest.raises(OSError, match="No such file"):
        server_context(str(tmp_path / "none"), files[1])
    with pytest.raises(ssl.SSLError):
        server_context(files[1], files[0])


def test_the_fingerprint_is_that_which_others_show(files):  # R-F10
    words = ["openssl", "x509", "-in", files[0], "-noout", "-fingerprint", "-sha256"]
    shown = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    assert shown.strip().endswith(fingerprint(files[0]))
    with pytest.raises(ValueError, match="substring"):
        fingerprint(files[1])
