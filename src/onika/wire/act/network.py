"""What a user does about other sites: where cards are looked for, and whose keys are trusted (requirement F06)."""

from onika.wire.act.act import Act


class LookAtNetwork(Act, frozen=True):
    """Look at all places; the value is a `view.NetworkView`. Nothing that is found is connected with, or kept."""


class AddPlace(Act, frozen=True):
    """Look for cards there too: `https://…`, a folder, `tcp/HOST:PORT` of a router, or `lan`."""

    place: str


class DropPlace(Act, frozen=True):
    """Look there no more."""

    place: str


class TrustSite(Act, frozen=True):
    """Take a key for that of the site of a name from now on, whatever was before."""

    name: str
    signer: str
