"""Leaves this process only the system calls that computing takes, by the kernel's filter (requirement X16).

What is left opens and reads files, maps memory, waits, and sends to and receives from what is open. There is no new
socket, process or thread, no look into another process, no signal to one, no new rights. It cannot be taken back.
"""

import ctypes
import errno
import os
import platform
import struct

_NO_NEW_PRIVILEGES = 38
_SET_FILTER, _FILTER = 22, 2
"""PR_SET_SECCOMP and SECCOMP_MODE_FILTER of prctl(2)."""

_LOAD, _EQUAL, _AT_LEAST, _RETURN = 0x20, 0x15, 0x35, 0x06
"""Instructions of the filter: load a word of what is called, compare it with a number, end."""
_NUMBER, _MACHINE, _FIRST_WORD, _SECOND_WORD = 0, 4, 16, 24
"""Where the number of the call, the machine and the first two arguments lie."""
_ALLOW, _REFUSE, _END = 0x7FFF0000, 0x00050000, 0x80000000
_OTHER_INTERFACE = 0x40000000
"""From here on numbers are those of another interface of the same machine (x32)."""

_MACHINES = {"x86_64": (0xC000003E, 0), "aarch64": (0xC00000B7, 1)}
"""By name: how the kernel calls it, and which number of a pair is its own."""

_CALLS = {
    "read": (0, 63), "write": (1, 64), "close": (3, 57), "fstat": (5, 80), "lseek": (8, 62), "mmap": (9, 222),
    "mprotect": (10, 226), "munmap": (11, 215), "brk": (12, 214), "rt_sigaction": (13, 134),
    "rt_sigprocmask": (14, 135), "rt_sigreturn": (15, 139), "pread64": (17, 67), "readv": (19, 65),
    "writev": (20, 66), "sched_yield": (24, 124), "mremap": (25, 216), "madvise": (28, 233), "nanosleep": (35, 101),
    "setitimer": (38, 103),
    "getpid": (39, 172), "sendto": (44, 206), "recvfrom": (45, 207), "sendmsg": (46, 211), "recvmsg": (47, 212),
    "exit": (60, 93), "uname": (63, 160), "getcwd": (79, 17), "gettimeofday": (96, 169),
    "sysinfo": (99, 179), "getuid": (102, 174), "getgid": (104, 176), "geteuid": (107, 175), "getegid": (108, 177),
    "sigaltstack": (131, 132), "gettid": (186, 178), "futex": (202, 98), "sched_getaffinity": (204, 123),
    "getdents64": (217, 61), "restart_syscall": (219, 128), "clock_gettime": (228, 113), "clock_getres": (229, 114),
    "clock_nanosleep": (230, 115), "exit_group": (231, 94), "openat": (257, 56), "newfstatat": (262, 79),
    "readlinkat": (267, 78), "faccessat": (269, 48), "pselect6": (270, 72), "ppoll": (271, 73), "dup": (32, 23),
    "getrandom": (318, 278), "membarrier": (324, 283), "statx": (332, 291), "rseq": (334, 293),
    "faccessat2": (439, 439),
}  # fmt: skip
"""What is left, by the numbers on both machines."""
_OLD_CALLS = {"open": 2, "stat": 4, "lstat": 6, "poll": 7, "access": 21, "select": 23, "readlink": 89, "time": 201}
"""The same in the older form that only x86_64 has."""
_OF_ITSELF = {"kill": (62, 129), "tgkill": (234, 131)}
"""Signals, which a process may send to itself: so it aborts."""

_OF_DESCRIPTORS = (72, 25)
_SETS_OWNER = (8, 10, 15)
"""What fcntl(2) may not be asked for: whom the system signals when something comes, and by which signal."""


def can_be_left_out() -> bool:
    """Whether the calls of this machine are known."""
    return platform.machine() in _MACHINES


def leave_only_computing() -> None:
    """Refuse all other calls from now on, as things not permitted; raises OSError where the kernel cannot."""
    program = _program()
    code = ctypes.create_string_buffer(program)
    header = struct.pack("HxxxxxxP", len(program) // 8, ctypes.addressof(code))
    library = ctypes.CDLL(None, use_errno=True)
    library.prctl(_NO_NEW_PRIVILEGES, 1, 0, 0, 0)
    if library.prctl(_SET_FILTER, _FILTER, ctypes.c_char_p(header), 0, 0):
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))


def _program() -> bytes:
    """The filter: each comparison leads to the line behind it, or over so many lines."""
    if not can_be_left_out():
        raise OSError(errno.ENOSYS, f"the calls of {platform.machine()} are not known")
    machine, column = _MACHINES[platform.machine()]
    left = [numbers[column] for numbers in _CALLS.values()] + ([] if column else list(_OLD_CALLS.values()))
    lines = [
        (_LOAD, 0, 0, _MACHINE),
        (_EQUAL, 1, 0, machine),
        (_RETURN, 0, 0, _END),
        (_LOAD, 0, 0, _NUMBER),
        (_AT_LEAST, 0, 1, _OTHER_INTERFACE),
        (_RETURN, 0, 0, _END),
    ]
    for number in left:
        lines += [(_EQUAL, 0, 1, number), (_RETURN, 0, 0, _ALLOW)]
    for numbers in _OF_ITSELF.values():
        lines += [
            (_EQUAL, 0, 3, numbers[column]),
            (_LOAD, 0, 0, _FIRST_WORD),
            (_EQUAL, 0, 1, os.getpid()),
            (_RETURN, 0, 0, _ALLOW),
            (_LOAD, 0, 0, _NUMBER),
        ]
    lines += [
        (_EQUAL, 0, 2 + len(_SETS_OWNER), _OF_DESCRIPTORS[column]),
        (_LOAD, 0, 0, _SECOND_WORD),
        *((_EQUAL, len(_SETS_OWNER) - number, 0, command) for number, command in enumerate(_SETS_OWNER)),
        (_RETURN, 0, 0, _ALLOW),
        (_RETURN, 0, 0, _REFUSE | errno.EPERM),
    ]
    return b"".join(struct.pack("HBBI", *line) for line in lines)
