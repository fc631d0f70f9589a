"""Confines this process, and all that it starts, to a few folders, by the kernel's Landlock (requirement X25).

Nothing else on the disk is read or written, no TCP connection is made and no port is taken; processes outside are sent
no signal. It cannot be taken back. What the kernel's version does not know is left out: `level` says what there is.
Sockets of the system that are files, as those of services, are not covered.
"""

import ctypes
import os
import struct
from collections.abc import Iterable
from pathlib import Path

_CREATE, _ADD_RULE, _RESTRICT = 444, 445, 446
"""Numbers of the system calls, the same on all machines."""
_VERSION_WANTED = 1
_PATH_BENEATH = 1
_NO_NEW_PRIVILEGES = 38

_EXECUTE, _WRITE_FILE, _READ_FILE, _READ_DIR = 1, 2, 4, 8
_OF_A_FILE = _EXECUTE | _WRITE_FILE | _READ_FILE | 1 << 14 | 1 << 15
"""Of what may be done below a folder: what may be done to a file that is named itself."""
_READING = _EXECUTE | _READ_FILE | _READ_DIR
_KNOWN = {1: 13, 2: 14, 3: 15, 4: 15, 5: 16}
"""By version: how many things may be done to files that it knows of."""
_CAPABILITIES, _SETS = struct.pack("Ii", 0x20080522, 0), 24
"""The header for our own capabilities, and the bytes of the three sets of them."""
_TCP = 0b11
_SCOPES = 0b11

_NETWORK_SINCE, _SCOPES_SINCE = 4, 6


def level() -> int:
    """The version of Landlock that the kernel has; 0: it has none."""
    return max(0, int(_libc().syscall(_CREATE, None, ctypes.c_size_t(0), ctypes.c_uint32(_VERSION_WANTED))))


def confine(reads: Iterable[Path], writes: Iterable[Path]) -> None:
    """Confine this thread and what it starts; raises OSError where the kernel cannot.

    reads    what may be read and executed, with all below it
    writes   what may be written besides
    """
    version = level()
    if not version:
        raise OSError("the kernel has no Landlock")
    every = (1 << _KNOWN.get(version, 16)) - 1
    rules = struct.pack(
        "QQQ",
        every,
        _TCP if version >= _NETWORK_SINCE else 0,
        _SCOPES if version >= _SCOPES_SINCE else 0,
    )
    libc = _libc()
    ruleset = _done(libc.syscall(_CREATE, rules, ctypes.c_size_t(len(rules)), ctypes.c_uint32(0)))
    try:
        for path in reads:
            _allow(libc, ruleset, path, every & _READING)
        for path in writes:
            _allow(libc, ruleset, path, every)
        _done(libc.prctl(_NO_NEW_PRIVILEGES, 1, 0, 0, 0))
        _done(libc.capset(_CAPABILITIES, bytes(_SETS)))  # root could look into other processes all the same
        _done(libc.syscall(_RESTRICT, ctypes.c_int(ruleset), ctypes.c_uint32(0)))
    finally:
        os.close(ruleset)


def _allow(libc: ctypes.CDLL, ruleset: int, path: Path, rights: int) -> None:
    """What is not there needs no leave."""
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except FileNotFoundError:
        return
    try:
        allowed = rights if path.is_dir() else rights & _OF_A_FILE
        rule = struct.pack("=Qi", allowed, place)
        _done(libc.syscall(_ADD_RULE, ctypes.c_int(ruleset), ctypes.c_int(_PATH_BENEATH), rule, ctypes.c_uint32(0)))
    finally:
        os.close(place)


def _done(code: int) -> int:
    if code < 0:
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))
    return code


def _libc() -> ctypes.CDLL:
    return ctypes.CDLL(None, use_errno=True)
