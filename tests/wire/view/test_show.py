import msgspec

from onika.wire import view


def test_where_a_button_leads_travels_with_its_name():  # R-X01
    remedy = view.Remedy("What fits here", show=view.ShowFits("1/17/0", 4))
    text = msgspec.json.encode(remedy)
    assert text == b'{"label":"What fits here","show":{"t":"ShowFits","flow":"1/17/0","after":4}}'
    assert msgspec.json.decode(text, type=view.Remedy) == remedy
