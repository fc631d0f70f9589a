"""The way to servers of libraries: who asks for files, with which password, and what of the answers is kept."""

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from typing import TypeVar

from onika.files.library_index import LARGEST_FILE, IndexedFile, LibraryIndex
from onika.store.remote.address import WebAddress, library_address
from onika.store.remote.code_pack import unpacked
from onika.store.remote.credential import Credential, kept_credential
from onika.store.remote.limits import Limits
from onika.store.remote.object_cache import ObjectCache
from onika.store.remote.source import INDEX, FolderSource, Wanted, object_path
from onika.store.remote.web_source import CONNECTIONS, WebSource
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

PASSWORD_REASONS = ("store.password_needed", "store.password_wrong")
"""The keys of what a server says who wants to know who asks."""

_T = TypeVar("_T")
_TRIES = 3
_FEW = 2 * CONNECTIONS
"""Files that come as fast one by one as in a pack."""

AskPassword = Callable[[str, Reason], Credential | None]
"""Of a server's name, and why it is asked; None: the user has none to give."""


class LibraryAccess:
    """Remembers passwords until it is closed, and writes none. Used by one thread at a time.

    state   the directory in which a user may keep tokens; None: there is none
    ask     asks the user for a password; None: nobody can be asked
    """

    def __init__(
        self, cache: ObjectCache, state: Path | None, ask: AskPassword | None = None, limits: Limits | None = None
    ) -> None:
        self.cache = cache
        self._state = state
        self._ask = ask
        self._limits = limits or Limits()
        self._credentials: dict[str, Credential] = {}
        self._sources: dict[str, WebSource] = {}

    def let_in(self, address: WebAddress, credential: Credential) -> None:
        """Use a password for a server from now on."""
        self._credentials[address.authority] = credential
        self._forget(address)

    def index(self, address: str) -> bytes | Reason:
        """The signed index of a library, as its place has it now."""
        answer = self._fetch(address, [Wanted(INDEX, LARGEST_FILE)], expects_more=True)
        return answer if isinstance(answer, Reason) else answer[INDEX]

    def pinned_index(self, address: str, digest: str) -> Reason:
        """Have the signed index of a version, by its digest, in the cache; why not, where that is not possible."""
        if self.cache.get(digest) is not None:
            return NOTHING
        return self._kept(address, {object_path(digest): (digest, LARGEST_FILE)})

    def bring(self, address: str, files: Iterable[IndexedFile], index: LibraryIndex | None = None) -> Reason:
        """Have files in the cache, all that are lacking at once; why not, where that is not possible.

        What is not the file that was signed is not kept; what came before it is. Many come in the pack of their
        `index`, where it has one.
        """
        lacking = self._lacking(files)
        if index is not None and index.pack and len(lacking) > _FEW:
            self._bring_pack(address, index)
            lacking = self._lacking(lacking)
        return self._kept(address, {object_path(file.digest): (file.digest, file.size) for file in lacking})

    def sent(self, address: str, path: str, body: bytes, most: int) -> bytes | Reason:
        """Send something to the site of a library, and what is answered; only a site of the web takes anything."""
        place = library_address(address)
        if isinstance(place, Reason):
            return place
        if isinstance(place, Path):
            return Reason.of("store.folder_takes_no_changes", path=str(place))
        return self._let_in(place, lambda source: source.send(path, body, most))

    def hang_up(self) -> None:
        """End all connections; passwords are remembered."""
        for source in self._sources.values():
            source.close()
        self._sources.clear()

    def _lacking(self, files: Iterable[IndexedFile]) -> list[IndexedFile]:
        return [file for file in files if self.cache.get(file.digest) is None]

    def _bring_pack(self, address: str, index: LibraryIndex) -> None:
        """Keep what the pack of an index holds; where it does not come, or is not good, files come one by one."""
        path = object_path(index.pack)
        answer = self._fetch(address, [Wanted(path, index.pack_size)])
        if not isinstance(answer, Reason):
            with suppress(OSError):  # it will be told of the file that cannot be written alone either
                self.cache.put_all(unpacked(answer[path], index).values())

    def close(self) -> None:
        """End all connections and forget all passwords."""
        self.hang_up()
        self._credentials.clear()

    def _kept(self, address: str, wanted: Mapping[str, tuple[str, int]]) -> Reason:
        if not wanted:
            return NOTHING
        answer = self._fetch(address, [Wanted(path, size) for path, (_, size) in wanted.items()])
        if isinstance(answer, Reason):
            return answer
        good = {path: content for path, content in answer.items() if sha256(content).hexdigest() == wanted[path][0]}
        try:
            self.cache.put_all(good.values())
        except OSError as error:
            return Reason.of("store.not_kept_here", path=str(self.cache.folder), why=system_reason(error))
        altered = sorted(answer.keys() - good.keys())
        return Reason.of("store.not_as_signed", path=altered[0]) if altered else NOTHING

    def _fetch(self, address: str, wanted: list[Wanted], *, expects_more: bool = False) -> Mapping[str, bytes] | Reason:
        """Files from their place; a password is asked for where the server wants one."""
        place = library_address(address)
        if isinstance(place, Reason):
            return place
        if isinstance(place, Path):
            return FolderSource(place).fetch(wanted)
        return self._let_in(place, lambda source: source.fetch(wanted), expects_more=expects_more)

    def _let_in(
        self, place: WebAddress, do: Callable[[WebSource], _T | Reason], *, expects_more: bool = False
    ) -> _T | Reason:
        """What is done at a server; where it wants a password, the user is asked."""
        answer = do(self._source(place, expects_more=expects_more))
        for _ in range(_TRIES):
            if not isinstance(answer, Reason) or answer.key not in PASSWORD_REASONS or self._ask is None:
                return answer
            credential = self._ask(place.authority, answer)
            if credential is None:
                return answer
            self.let_in(place, credential)
            answer = do(self._source(place, expects_more=expects_more))
        return answer

    def _source(self, place: WebAddress, *, expects_more: bool = False) -> WebSource:
        key = _key(place)
        if key not in self._sources:
            credential = self._credentials.get(place.authority)
            if credential is None and self._state is not None:
                credential = kept_credential(self._state, place.host, place.port)
            self._sources[key] = WebSource(place, self._limits, credential)
            if expects_more:
                self._sources[key].expect_more()
        return self._sources[key]

    def _forget(self, place: WebAddress) -> None:
        source = self._sources.pop(_key(place), None)
        if source is not None:
            source.close()


def _key(place: WebAddress) -> str:
    return f"{place.authority}{place.path}"
