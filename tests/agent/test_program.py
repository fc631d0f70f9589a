"""A site as a process: it launches what is listed, hands it over, and ends with all that it has launched."""

import os
import shutil
import signal
import subprocess
from pathlib import Path
from time import monotonic

import pytest

from kit.process.process_tree import descendants, runtime_of
from kit.process.site_process import ONIKA, SiteProcess
from onika.desk.run.remote_runtime import connect
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_client import SiteClient
from onika.wire import live, request
from onika.wire.runtime_standing import Standing

pytestmark = pytest.mark.site

_PATIENCE_S = 20.0


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    process = SiteProcess(tmp_path_factory.mktemp("cmu"))
    yield process
    assert process.end() in (0, 128 + signal.SIGTERM)


def client(site, user, name=""):
    host, _, port = site.place.rpartition(":")
    return SiteClient(SiteAddress(host, int(port), name, is_private=False), user)


def ran(site, *words, token="ann"):
    environment = site.environment | {"ONIKA_TOKEN": token}
    command = [str(ONIKA), *words]
    return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=False)


def test_a_run_at_a_site_is_as_one_here_and_what_is_not_listed_is_no_run(site):  # R-A15 R-F02
    there = ran(site, "run", "go_home", "--runtime", f"site://{site.place}/arm", token="kim")
    assert there.returncode == 0, there.stdout + there.stderr
    here = ran(site, "run", "go_home", "--virtual")
    assert there.stdout.splitlines()[-1] == here.stdout.splitlines()[-1], "the same hash"
    for name, why in (("/sh", "does not launch sh; it launches arm, crane"), ("", "name one of them behind the host")):
        with pytest.raises(LinkLost, match=why), connect(f"site://{site.place}{name}", "ann"):
            pass


def test_who_is_there_is_on_the_card_and_keeps_others_from_ending_it(site):  # R-A15 R-F06
    with connect(f"site://{site.place}/arm", "bob") as runtime:
        assert isinstance(runtime.ask(live.Take("s0")), request.Done)
        until = monotonic() + _PATIENCE_S
        while (card := client(site, "ann").card().launches[0]).users != ("bob",):
            assert monotonic() < until, card
        assert (card.state, card.worlds, card.robot, card.is_virtual) == ("running", ("boxes",), "arm_left", True)
        with pytest.raises(LinkLost, match="bob are there"):
            client(site, "ann", "arm").end()
        with pytest.raises(LinkLost, match="operator is wanted"):
            client(site, "eve", "arm").launch()
        client(site, "kim", "arm").end()
        with pytest.raises(LinkLost) as lost:
            list(runtime.events(_PATIENCE_S))
            runtime.ask(live.Survey())
        assert "kim" in str(lost.value) or lost.value.cause in (LossCause.OVER, LossCause.CLOSED)


def test_a_site_that_is_killed_leaves_nothing_that_moves(tmp_path):  # R-A15 R-X12
    site = SiteProcess(tmp_path / "sandia", "sandia")
    client(site, "ann", "arm").launch()
    below = [*descendants(site.process.pid), runtime_of(site.process.pid)]
    os.kill(site.process.pid, signal.SIGKILL)
    until = monotonic() + _PATIENCE_S
    while any(Path(f"/proc/{pid}/cwd").exists() for pid in below):
        assert monotonic() < until
    site.end()


def test_over_tls_the_runtime_is_reached_over_tls_with_the_same_token(tmp_path):  # R-A15 R-X12
    if shutil.which("openssl") is None:
        pytest.skip("there is no openssl to make a certificate with")
    cert, key = tmp_path / "cert.pem", tmp_path / "key.pem"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                    "-days", "2", "-subj", "/CN=onika", "-addext", "subjectAltName=DNS:localhost",
                    "-keyout", str(key), "-out", str(cert)], check=True, capture_output=True)  # fmt: skip
    secured = ("--listen", "0.0.0.0:0", "--cert", str(cert), "--key", str(key), "--host-name", "localhost")
    site = SiteProcess(tmp_path / "tls", "tls", more=secured)
    url = f"site://localhost:{site.place.rpartition(':')[2]}/arm?tls"
    with connect(url, "ann", cert) as runtime:
        assert isinstance(runtime.ask(live.Survey()), Standing)
    with pytest.raises(LinkLost) as untrusted:
        SiteClient(SiteAddress.parse(url), "ann").card()
    assert untrusted.value.cause is LossCause.CERTIFICATE
    site.end()
