from kit.desk.dictionary_fixture import DictionaryFixture, plain


def test_a_cabinet_has_a_laboratory_the_shipped_ones_and_a_home_of_the_users_own(tmp_path):
    cabinet = DictionaryFixture(tmp_path, plain("grip"))
    assert cabinet.names == ["grip"] and "jmoveC" in cabinet.environment.tree.onikons
    assert [base.path for base in cabinet.site.directories][:2] == [cabinet.base.path, cabinet.own.path]
    assert cabinet.look() == 0 and cabinet.told == ()
    cabinet.base.save_onikon(plain("loosen"))
    assert cabinet.look() == 1 and cabinet.names == ["grip", "loosen"]
    cabinet.define("ONIKON Weld job", "LEFTEDGE 1", "RIGHTEDGE 1")
    cabinet.look()
    assert "Weld job" in cabinet.environment.tree.types and cabinet.icon("grip").type == "Complete job"
