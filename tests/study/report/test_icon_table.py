from onika.study.measures import IconSelection
from onika.study.report.icon_table import icons_of
from onika.study.subject import Subject


def test_the_slowest_icon_stands_first_and_who_is_removed_does_not_count():  # R-H02
    first = Subject("p1", selections=(IconSelection("a", 1, 2.0), IconSelection("b", 2, 5.0)))
    second = Subject("p2", selections=(IconSelection("a", 1, 4.0),))
    gone = Subject("p3", removed="ill", selections=(IconSelection("a", 1, 99.0),))
    rows = [(icon.name, icon.count, icon.mean_s, icon.longest_s) for icon in icons_of((first, second, gone))]
    assert rows == [("b", 1, 5.0, 5.0), ("a", 2, 3.0, 4.0)]
