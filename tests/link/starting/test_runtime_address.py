import pytest

from onika.link.address import Address
from onika.link.starting.runtime_address import address_of
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.ssh_address import SshAddress


def test_each_kind_of_address_is_read_by_its_scheme():  # R-A15
    assert address_of("ssh://robot?stay") == SshAddress("robot", stays=True)
    assert address_of("site://robot/arm") == SiteAddress("robot", name="arm")
    assert address_of("wss://robot") == Address.parse("wss://robot")


@pytest.mark.parametrize("text", ["ssh:robot", "site:robot", "robot", ""])
def test_what_is_none_says_what_was_expected(text):  # R-A15
    with pytest.raises(ValueError, match="expected"):
        address_of(text)
