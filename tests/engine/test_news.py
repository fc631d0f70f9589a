from typing import get_args

from msgspec import Struct

from onika.engine import news
from onika.wire.steer import Steering


def test_every_news_is_a_frozen_value_that_says_what_it_tells():
    for each in set(get_args(news.News)) - set(get_args(Steering)):
        assert issubclass(each, Struct)
        assert each.__struct_config__.frozen
        assert each.__doc__
        assert not each.__doc__.startswith(each.__name__ + "(")


def test_a_finish_without_words_means_flow_0_and_no_loop():  # Table 9
    assert news.Finished(0, "move") == news.Finished(0, "move", choice=0, loop=False)
