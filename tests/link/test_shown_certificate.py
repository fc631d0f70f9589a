import pytest

from kit.link.private_door import PrivateDoor
from onika.link.lost import LinkLost, LossCause
from onika.link.shown_certificate import fingerprint_of, shown_certificate, unfit


def test_a_certificate_is_shown_before_anybody_trusts_it(tmp_path):  # R-F02
    door = PrivateDoor(tmp_path)
    try:
        certificate = shown_certificate("127.0.0.1", door.port)
        assert certificate == door.der and len(fingerprint_of(certificate)) == 95
        assert unfit("127.0.0.1", door.port, certificate) is None
    finally:
        door.close()


def test_one_of_another_name_would_not_do(tmp_path):  # R-F02
    door = PrivateDoor(tmp_path, "DNS:robot.example")
    try:
        why = unfit("127.0.0.1", door.port, shown_certificate("127.0.0.1", door.port))
        assert why is not None and "mismatch" in why.text
    finally:
        door.close()


def test_where_nobody_listens_that_is_told():
    with pytest.raises(LinkLost) as lost:
        shown_certificate("127.0.0.1", 1)
    assert lost.value.cause is LossCause.UNREACHABLE
