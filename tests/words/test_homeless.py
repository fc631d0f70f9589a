import pytest

from onika.words.homeless import homeless


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('File "/home/ana/lab/module/zdiff.py", line 41', 'File "~/lab/module/zdiff.py", line 41'),
        ("/Users/ana/x and /home/bob", "~/x and ~"),
        ("/root/x.py, not /srv/root/x", "~/x.py, not /srv/root/x"),
        (r"C:\\Users\\ana\\x", r"~\\x"),
        ("/opt/robots/x.py", "/opt/robots/x.py"),
        ("homes of /homestead", "homes of /homestead"),
    ],
)
def test_nobody_is_named_by_a_path(text, expected):  # R-X21: nothing secret
    assert homeless(text) == expected


def test_a_home_elsewhere_is_meant_too():  # R-X21: nothing secret
    assert homeless("/data/ana/x /data/anabel/x", "/data/ana") == "~/x /data/anabel/x"
    assert homeless("/x", "/") == "/x"
