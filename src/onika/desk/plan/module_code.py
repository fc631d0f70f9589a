"""The code of a module as it goes into a plan: named by its content, and with the rights that its file has here."""

from hashlib import sha256
from pathlib import Path

from msgspec import structs

from onika.store.remote.rights import is_confined
from onika.wire.plan import Code


def module_code(module: str, path: Path, source: str) -> Code:
    """Of a library of others that has no rights here it is sandboxed wherever it is executed (requirement X16)."""
    return Code(sha256(source.encode()).hexdigest(), module, str(path), source, is_sandboxed=is_confined(path))


def with_rights_here(code: Code) -> Code:
    """Code that came with a file, such as a recording: sandboxed, but where the same stands here with rights."""
    path = Path(code.path)
    try:
        is_own = path.read_bytes() == code.source.encode() and not is_confined(path)
    except OSError:
        is_own = False
    return structs.replace(code, is_sandboxed=not is_own)
