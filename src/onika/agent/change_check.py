"""What is looked at in a file before a site takes it into its library: that it is one (requirement F03).

What it does is judged by nobody: whoever may send files is trusted as somebody who may bring code.
"""

from collections.abc import Callable, Iterable, Mapping
from functools import partial

from onika.files import appl, conf, onk, rmod, world
from onika.files.library_index import ENDINGS, LARGEST_FILE, is_path
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.reason import NOTHING, Reason

_TEXTS = (".toml", ".dta", ".sets", ".test", ".py")
_CODE = ".py"

_Reads = Callable[[str, str, str], tuple[object, Iterable[Fault]]]


class ChangeCheck:
    """For the formats of a site, whose icons have these types."""

    def __init__(self, types: Syntax) -> None:
        self._readers: Mapping[str, _Reads] = {
            rmod.ENDING: rmod.read,
            conf.ENDING: conf.read,
            world.ENDING: world.read,
            onk.ENDING: partial(onk.read, syntax=types),
            appl.ENDING: partial(appl.read, syntax=types),
        }

    def refusal(self, path: str, content: bytes) -> Reason:
        """Why this is no file of a library; NOTHING where it is."""
        if not is_path(path):
            return Reason.of("files.index_path", path=path[:200])
        if len(content) > LARGEST_FILE:
            return Reason.of("files.index_file_large", path=path, size=len(content), most=LARGEST_FILE)
        name, dot, ending = path.rpartition("/")[2].rpartition(".")
        reads = self._readers.get(dot + ending)
        if reads is None and (dot + ending not in _TEXTS or not ENDINGS[path.partition("/")[0]]):
            return NOTHING
        try:
            text = content.decode("utf-8")
        except UnicodeDecodeError:
            return Reason.of("site.file_no_text", path=path)
        if reads is not None:
            faults = [fault for fault in reads(text, name, path)[1] if not fault.is_note]
            return Reason.of("site.file_at_fault", why=faults[0].sentence) if faults else NOTHING
        return _wrong_code(path, text) if dot + ending == _CODE else NOTHING


def _wrong_code(path: str, text: str) -> Reason:
    """Why no module is made of a text; it is not executed."""
    try:
        compile(text, path, "exec", dont_inherit=True)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as wrong:
        return Reason.of("site.file_at_fault", why=Reason.plain(f"{path}: {wrong}"))
    return NOTHING
