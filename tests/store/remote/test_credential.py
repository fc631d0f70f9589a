from onika.store.remote.credential import Credential, kept_credential


def test_a_name_with_a_password_and_a_token_are_sent_in_their_ways():  # R-F03
    assert Credential("secret", "ann").header == "Basic YW5uOnNlY3JldA=="
    assert Credential("abc").header == "Bearer abc"


def test_a_secret_is_not_shown():  # R-F03
    assert "secret" not in repr(Credential("secret", "ann"))


def test_a_user_may_keep_one_for_each_server(tmp_path):  # R-F03
    folder = tmp_path / "library-tokens"
    folder.mkdir()
    (folder / "host").write_text("abc\n")
    (folder / "host:8443").write_text("ann:se:cret\n")
    assert kept_credential(tmp_path, "host", 443) == Credential("abc")
    assert kept_credential(tmp_path, "host", 8443) == Credential("se:cret", "ann")
    assert kept_credential(tmp_path, "other", 443) is None


def test_no_file_elsewhere_is_taken_for_one(tmp_path):  # R-X16
    (tmp_path / "token").write_text("abc")
    (tmp_path / "library-tokens").mkdir()
    for host in ("../token", "..", ".", "a/../../token"):
        assert kept_credential(tmp_path, host, 443) is None
    (tmp_path / "library-tokens/host").write_text("a\x1b[0m")
    assert kept_credential(tmp_path, "host", 443) is None
