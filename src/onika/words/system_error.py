"""Why the operating system has refused something, in words that say what is used up and where that is set."""

import errno
from collections.abc import Mapping

from onika.words.reason import Reason, reason_of

_REASONS: Mapping[int, Reason] = {
    errno.ENOSPC: Reason.of("words.disk_full"),
    errno.EDQUOT: Reason.of("words.quota_used"),
    errno.EROFS: Reason.of("words.disk_read_only"),
    errno.EFBIG: Reason.of("words.file_limit"),
    errno.EMFILE: Reason.of("words.descriptors_used"),
    errno.ENFILE: Reason.of("words.descriptors_used_by_all"),
    errno.ENOMEM: Reason.of("words.memory_used"),
    errno.EACCES: Reason.of("words.not_permitted"),
    errno.EPERM: Reason.of("words.not_permitted"),
    errno.ENOENT: Reason.of("words.no_such_file"),
    errno.EEXIST: Reason.of("words.file_exists"),
    errno.ENOTDIR: Reason.of("words.not_a_directory"),
    errno.EISDIR: Reason.of("words.is_a_directory"),
    errno.ENAMETOOLONG: Reason.of("words.name_too_long"),
    errno.EIO: Reason.of("words.io_error"),
    errno.ELOOP: Reason.of("words.link_loop"),
    errno.ECONNREFUSED: Reason.of("words.connection_refused"),
    errno.ECONNRESET: Reason.of("words.connection_reset"),
    errno.EPIPE: Reason.of("words.broken_pipe"),
    errno.ETIMEDOUT: Reason.of("words.connection_timed_out"),
    errno.EHOSTUNREACH: Reason.of("words.host_unreachable"),
    errno.ENETUNREACH: Reason.of("words.network_unreachable"),
    errno.EADDRINUSE: Reason.of("words.address_in_use"),
    errno.EADDRNOTAVAIL: Reason.of("words.address_unavailable"),
}


_USED_UP = frozenset((errno.ENOSPC, errno.EDQUOT, errno.EMFILE, errno.ENFILE, errno.ENOMEM, errno.EFBIG))


def is_used_up(error: OSError) -> bool:
    """Whether the system has nothing more to give, which is no fault of whoever asked for it."""
    return error.errno in _USED_UP


def system_reason(error: OSError) -> Reason:
    """The reason, without the name of the file: whoever says it has named that already."""
    if error.errno is None or not isinstance(error.args[0], int):
        return reason_of(error)
    return _REASONS.get(error.errno) or Reason.plain(error.strerror or type(error).__name__)


def system_reason_with_place(error: OSError) -> Reason:
    """The same with the name of the file, where there is one."""
    if error.filename is None:
        return system_reason(error)
    return Reason.of("words.system_place", place=str(error.filename), why=system_reason(error))
