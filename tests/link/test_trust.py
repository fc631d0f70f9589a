import ssl

import pytest

from onika.link.lost import LinkLost, LossCause
from onika.link.trust import trusting


def test_nobody_is_believed_without_a_certificate():  # R-X12
    context = trusting(None)
    assert context.verify_mode is ssl.CERT_REQUIRED and context.check_hostname
    assert context.minimum_version is ssl.TLSVersion.TLSv1_2


def test_a_file_of_certificates_that_is_none_is_told(tmp_path):
    path = tmp_path / "ca"
    path.write_text("nothing")
    with pytest.raises(LinkLost, match="ca") as lost:
        trusting(path)
    assert lost.value.cause is LossCause.CERTIFICATE
