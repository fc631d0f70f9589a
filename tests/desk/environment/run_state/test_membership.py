from kit.labs.laboratory import HOLE, job, joints
from onika.desk.environment.run_state.membership import StepMembership, icons
from onika.files import appl
from onika.model.flow_path import numbered
from onika.store.site import open_site

SYNTAX, _ = open_site([], {}, None).syntax()


def application(*steps):
    text = "\n".join(["VERSION     2.0\n", "APPLTYPE    conditional\n", "FLOW\n", *steps, "ENDFLOW\n", "EOF\n"])
    read, faults = appl.read(text, "play", "play.appl", SYNTAX)
    assert faults == ()
    return numbered(read, 0)[0]


def test_a_target_or_the_hole_for_one_belongs_to_its_action():
    there = joints("there", *[0.0] * 6)
    membership = StepMembership.of(
        application(job("aC"), job("jC", "Joint job"), there, job("jC", "Joint job"), HOLE), SYNTAX
    )
    assert membership.owners == {3: 2, 5: 4}
    assert membership.meant(1) == {(1,)} and membership.meant(3) == {(2,)}


def test_a_branch_means_all_that_stands_in_it():  # R-D13
    inner = ["BRANCH\nFLOW\n", job("cC"), "ENDFLOW\nFLOW\n", job("dC"), "ENDFLOW\nENDBRANCH\n"]
    outer = ["BRANCH\nFLOW\n", job("aC"), *inner, "ENDFLOW\nFLOW\n", job("bC"), "ENDFLOW\nENDBRANCH\n"]
    here = application(*outer)
    numbers = {icon.onikon.name: icon.number for icon in icons(here)}
    membership = StepMembership.of(here, SYNTAX)
    branch = here.flows[0].steps[0].number
    assert list(numbers) == ["aC", "cC", "dC", "bC"]
    (inner_branch,) = (step for step in membership.inside if step != branch)
    assert membership.meant(branch) == {(number,) for number in (*numbers.values(), inner_branch)}
    assert membership.meant(numbers["cC"]) == {(numbers["cC"],)}
