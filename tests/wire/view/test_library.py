import msgspec

from onika.wire import view


def test_a_library_without_faults_says_none():
    assert msgspec.to_builtins(view.LibraryView("lab", "/lab", 0, 3)) == {
        "name": "lab",
        "path": "/lab",
        "order": 0,
        "tasks": 3,
    }
