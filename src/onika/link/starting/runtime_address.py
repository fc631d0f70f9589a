"""An address of any kind: of a runtime that is there, or of one that ssh or a site starts (requirement A15)."""

from onika.link.address import Address
from onika.link.starting import site_address, ssh_address
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.ssh_address import SshAddress

RuntimeAddress = Address | SshAddress | SiteAddress


def address_of(text: str) -> RuntimeAddress:
    """The address that a text is; raises ValueError that says what was expected and found."""
    if text.startswith(f"{ssh_address.SCHEME}:"):
        return SshAddress.parse(text)
    if text.startswith(f"{site_address.SCHEME}:"):
        return SiteAddress.parse(text)
    return Address.parse(text)
