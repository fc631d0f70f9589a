"""An alarm clock that `select` can wait for: a Linux timer with a descriptor (Python has it from 3.13 on)."""

import ctypes
import os

_CLOCK_MONOTONIC = 1
_FLAGS = os.O_CLOEXEC | os.O_NONBLOCK


class _Spec(ctypes.Structure):
    _fields_ = (
        ("every_s", ctypes.c_long),
        ("every_ns", ctypes.c_long),
        ("in_s", ctypes.c_long),
        ("in_ns", ctypes.c_long),
    )


class Alarm:
    """Its descriptor can be read once the time set has passed, until it is set anew or stopped."""

    def __init__(self) -> None:
        self._library = ctypes.CDLL(None, use_errno=True)
        self._descriptor = self._call(self._library.timerfd_create(_CLOCK_MONOTONIC, _FLAGS))

    def fileno(self) -> int:
        """Its descriptor."""
        return self._descriptor

    def set(self, in_ns: int) -> None:
        """Ring in so many nanoseconds of wall time, in place of any other time."""
        seconds, rest = divmod(max(in_ns, 1), 1_000_000_000)
        self._set(_Spec(0, 0, seconds, rest))

    def stop(self) -> None:
        """Do not ring, or ring no more."""
        self._set(_Spec())

    def close(self) -> None:
        """Give the descriptor back."""
        os.close(self._descriptor)

    def _set(self, spec: _Spec) -> None:
        self._call(self._library.timerfd_settime(self._descriptor, 0, ctypes.byref(spec), None))

    def _call(self, result: int) -> int:
        if result < 0:
            code = ctypes.get_errno()
            raise OSError(code, os.strerror(code))
        return result
