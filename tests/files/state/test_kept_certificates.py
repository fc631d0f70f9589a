import ssl

from kit.link.private_door import made_certificate
from onika.files.state.kept_certificates import certificate_path, keep_certificate, trusting_kept


def kept(tmp_path, host):
    environment = {"XDG_STATE_HOME": str(tmp_path / "state")}
    certificate, _ = made_certificate(tmp_path, f"DNS:{host}")
    return environment, keep_certificate(host, ssl.PEM_cert_to_DER_cert(certificate.read_text()), environment)


def test_a_certificate_is_trusted_for_its_host_alone(tmp_path):  # R-F02
    environment, path = kept(tmp_path, "robot.example")
    assert path == certificate_path("ROBOT.example", environment) and path.stat().st_mode & 0o077 == 0
    own = [ca for ca in trusting_kept("robot.example", environment).get_ca_certs() if ca["subject"] == _named("robot")]
    others = trusting_kept("arm.example", environment).get_ca_certs()
    assert own and not [ca for ca in others if ca["subject"] == _named("robot")]


def test_what_is_kept_and_cannot_be_read_lets_nobody_in(tmp_path):
    environment, path = kept(tmp_path, "robot.example")
    path.write_text("nothing")
    context = trusting_kept("robot.example", environment)
    assert context.verify_mode is ssl.CERT_REQUIRED and context.check_hostname
    assert not [ca for ca in context.get_ca_certs() if ca["subject"] == _named("robot")]


def test_no_host_names_a_file_elsewhere(tmp_path):  # R-X12
    environment = {"XDG_STATE_HOME": str(tmp_path)}
    folder = tmp_path / "onika" / "certificates"
    for host in ("../../x", "a/b", "..", "::1", ".x"):
        assert certificate_path(host, environment).parent == folder


def _named(name):
    return ((("commonName", name),),)
