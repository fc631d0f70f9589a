"""A piece of memory that several processes share, on a memfd: nothing is left behind when they die (law 31)."""

import mmap
import os
import weakref

from onika.words.reason import Reason
from onika.words.system_error import system_reason


class SharedMemoryRefused(OSError):
    """There is no more shared memory, or no descriptor for it; raised with the reason."""


class Segment:
    """Zeroed shared memory; untouched pages cost nothing. Hand `fd` to another process to share it."""

    def __init__(self, fd: int, size: int) -> None:
        self.fd = fd
        self.size = size
        self._end = weakref.finalize(self, os.close, fd)  # whoever forgets to close it leaves no descriptor behind
        self._map = mmap.mmap(fd, size)
        self._keep_from_copies()
        self.view = memoryview(self._map)

    @classmethod
    def create(cls, name: str, size: int) -> "Segment":
        """New memory of `size` bytes; the name is only seen in the process's list of files.

        Raises SharedMemoryRefused.
        """
        fd = -1
        try:
            fd = os.memfd_create(f"onika-{name}", os.MFD_CLOEXEC)
            os.ftruncate(fd, size)
        except OSError as error:
            if fd >= 0:
                os.close(fd)
            refused = SharedMemoryRefused(Reason.of("words.shared_memory", why=system_reason(error)))
            refused.errno = error.errno
            raise refused from None
        return cls(fd, size)

    @classmethod
    def attach(cls, fd: int) -> "Segment":
        """Memory that another process made, by a file descriptor of our own for it."""
        return cls(fd, os.fstat(fd).st_size)

    def _keep_from_copies(self) -> None:
        """A copy of this process, which a module makes by forking, would write it too: there it is not mapped."""
        if hasattr(mmap, "MADV_DONTFORK"):
            self._map.madvise(mmap.MADV_DONTFORK)

    def close(self) -> None:
        """Give the memory back; views of it that are still in use keep the map alive until they go."""
        try:
            self.view.release()
            self._map.close()
        except BufferError:
            pass  # a reader still holds a view: the map goes with the last one
        self._end()
