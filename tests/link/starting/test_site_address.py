import pytest
from hypothesis import given, strategies as st

from onika.link.address import Address
from onika.link.starting.site_address import SiteAddress


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("site://robot.example.org/arm", SiteAddress("robot.example.org", name="arm")),
        ("site://robot:80/arm?stay", SiteAddress("robot", 80, "arm", stays=True)),
        ("site://[2001:db8::1]", SiteAddress("2001:db8::1")),
        ("site://127.0.0.1/arm", SiteAddress("127.0.0.1", name="arm", is_private=False)),
        ("site://localhost/arm?stay&tls", SiteAddress("localhost", name="arm", stays=True)),
    ],
)
def test_an_address_is_read_and_written(text, address):  # R-A15
    assert SiteAddress.parse(text) == address
    assert SiteAddress.parse(str(address)) == address


@pytest.mark.parametrize(
    "text",
    [
        "site:", "site://", "http://robot/arm", "site://ann@robot/arm", "site://robot:0/arm", "site://robot:x/arm",
        "site://robot/arm/left", "site://robot/a b", "site://robot/../card", "site://robot/arm#now", "site://[::1",
        "site://ro;bot/arm",
    ],
)  # fmt: skip
def test_what_is_no_address_is_refused_with_what_was_expected(text):  # R-A15
    with pytest.raises(ValueError, match="expected site://") as wrong:
        SiteAddress.parse(text)
    assert text in str(wrong.value)


@pytest.mark.parametrize("word", ["virtual", "stay=yes", "command=reboot"])
def test_a_word_that_is_not_known_is_named(word):  # R-A15
    with pytest.raises(ValueError, match="expected stay or tls"):
        SiteAddress.parse(f"site://robot/arm?{word}")


def test_a_runtime_is_reached_as_its_site_is():  # R-A15 R-X12
    assert SiteAddress.parse("site://robot/arm").runtime(7000) == Address("robot", 7000, True)
    assert SiteAddress.parse("site://localhost/arm").runtime(7000) == Address("localhost", 7000, False)


@given(st.text(max_size=20))
def test_whatever_is_let_through_is_one_name_in_a_path(text):  # R-A15
    try:
        address = SiteAddress.parse(f"site://robot/{text}")
    except ValueError:
        return
    assert not set(address.name) & set("/?# \n\r:%")
