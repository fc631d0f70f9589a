import ssl

import pytest

from kit.link.private_door import PrivateDoor
from onika.files.state.kept_certificates import keep_certificate
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_client import SiteClient
from onika.link.trust import trusting


def test_nobody_is_believed_without_a_certificate():  # R-X12
    context = trusting(None, "robot.example")
    assert context.verify_mode is ssl.CERT_REQUIRED and context.check_hostname
    assert context.minimum_version is ssl.TLSVersion.TLSv1_2


def test_a_file_of_certificates_that_is_none_is_told(tmp_path):
    path = tmp_path / "ca"
    path.write_text("nothing")
    with pytest.raises(LinkLost, match="ca") as lost:
        trusting(path, "robot.example")
    assert lost.value.cause is LossCause.CERTIFICATE


def test_a_machine_with_a_certificate_of_its_own_is_reached_once_that_is_kept(tmp_path, monkeypatch):  # R-F02
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    door = PrivateDoor(tmp_path)
    client = SiteClient(SiteAddress("127.0.0.1", door.port), "token")
    try:
        with pytest.raises(LinkLost) as lost:
            client.card()
        assert lost.value.reason.key == "link.untrusted_own"
        assert lost.value.reason.args["place"] == f"127.0.0.1:{door.port}"
        keep_certificate("127.0.0.1", door.der)
        with pytest.raises(LinkLost) as lost:
            client.card()
        assert lost.value.cause is not LossCause.CERTIFICATE  # it is spoken to now, and is no site
    finally:
        door.close()
