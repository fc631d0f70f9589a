from pathlib import Path

from onika.store.base_directory import BaseDirectory
from onika.store.search_path import with_base


def test_a_base_directory_comes_where_the_search_path_has_it_else_last(tmp_path: Path) -> None:  # R-B08
    search = [tmp_path / name for name in "abc"]
    first, second, third = map(BaseDirectory, search)
    beside = BaseDirectory(tmp_path / "beside")
    assert with_base([second, beside], first, search) == [first, second, beside]
    assert with_base([first, third, beside], second, search) == [first, second, third, beside]
    assert with_base([first], beside, search) == [first, beside]
    assert with_base([beside], third, search) == [third, beside]
