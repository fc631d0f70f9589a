from dataclasses import replace
from datetime import date

import pytest

from onika.files import library_lock
from onika.files.library_lock import Agreement, LockedFile, LockedLibrary

KEY = "SHA256:" + "k" * 43
LIBRARY = LockedLibrary(
    "cmu.puma",
    "https://robots.cmu.edu/library/puma",
    KEY,
    "2026-11-22 ann",
    42,
    "77" * 32,
    date(2027, 2, 22),
    "",
    {"module/pd.rmod": LockedFile("1c" * 32, 412), "module/pd.py": LockedFile("9f" * 32, 1834)},
    {"pd": Agreement(frozenset({"T_REF", "Q^_REF"}), frozenset({"boxes:arm"})), "still": Agreement()},
)
TEXT = library_lock.write([LIBRARY])


def test_a_lock_is_read_as_it_was_written():  # R-X16
    both = (
        LIBRARY,
        replace(
            LIBRARY,
            name="sandia",
            address="/a folder/of ours",
            next_key=KEY,
            agreed={},
            bases={"module/pd.rmod": "5a" * 32},
            has_all_rights=True,
        ),
    )
    assert library_lock.read(library_lock.write(both), "onika.lock", "onika.lock") == (both, ())
    assert library_lock.read(library_lock.write(()), "onika.lock", "onika.lock") == ((), ())


def test_a_lock_says_in_order_what_it_locks_so_that_differences_read_well():  # R-X16
    assert TEXT.splitlines()[2:] == [
        "LIBRARY     cmu.puma https://robots.cmu.edu/library/puma",
        f"SIGNER      {KEY} 2026-11-22 ann",
        f"INDEX       42 sha256:{'77' * 32} 2027-02-22",
        f"FILE        module/pd.py sha256:{'9f' * 32} 1834",
        f"FILE        module/pd.rmod sha256:{'1c' * 32} 412",
        "WRITES      pd Q^_REF T_REF",
        "WRITES      still nothing",
        "MAY         pd boxes:arm",
        "",
        "EOF",
    ]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (KEY, "SHA256:short"),
        ("sha256:77", "sha256:7g"),
        ("2027-02-22", "2027-02-32"),
        ("module/pd.py", "module/../../pd.py"),
        (" 1834", " -1"),
        ("WRITES      still", "WRITES      pd"),
        ("cmu.puma ", "../x "),
        ("INDEX       42", "INDEX       many"),
    ],
)
def test_nothing_is_made_of_a_lock_that_is_at_fault(old, new):  # R-X16
    read, faults = library_lock.read(TEXT.replace(old, new, 1), "onika.lock", "onika.lock")
    assert read is None
    assert faults


def test_a_library_stands_in_a_lock_once():  # R-X16
    block = TEXT.removeprefix("VERSION     2.0\n").removesuffix("\nEOF\n").rstrip("\n") + "\n"
    read, faults = library_lock.read(f"VERSION     2.0\n{block}{block}EOF\n", "onika.lock", "onika.lock")
    assert read is None
    assert [fault.reason.key for fault in faults] == ["files.every_name_once"]
