from collections import Counter
from xml.etree import ElementTree

import flame_graph

STACKS = Counter({("main", "work", "a<b>"): 60, ("main", "work"): 15, ("main", "rest"): 25})


def test_the_share_of_a_function_is_its_own_without_those_it_calls():
    assert flame_graph.shares(STACKS) == [(0.6, "a<b>"), (0.25, "rest"), (0.15, "work")]


def test_the_picture_is_as_wide_as_it_took_long_and_callers_are_below():
    picture = ElementTree.fromstring(flame_graph.flame_graph(STACKS))
    boxes = {group[0].text: group[1].attrib for group in picture}
    assert float(boxes["main 100.0%"]["width"]) == 1200.0
    assert float(boxes["work 75.0%"]["width"]) == 900.0
    assert float(boxes["a<b> 60.0%"]["y"]) < float(boxes["work 75.0%"]["y"]) < float(boxes["main 100.0%"]["y"])


def test_what_works_is_found_on_the_stack():
    def busy():
        sum(range(50_000))

    stacks = flame_graph.sampled(busy, 0.05)
    assert any("test_flame_graph.busy" in stack for stack in stacks)


def test_each_name_is_a_work_that_can_be_repeated():
    assert set(flame_graph.works()) == {"loop", "switch", "assembly"}
    work = flame_graph.works()["loop"]()
    work()
    work()
