from onika.link.caller import PARENT, Role


def test_each_role_may_what_those_before_it_may():
    assert [role.word for role in sorted(Role)] == ["viewer", "operator", "programmer", "owner"]


def test_the_launching_program_is_an_owner_on_this_machine():
    assert (PARENT.role, PARENT.is_near) == (Role.OWNER, True)
