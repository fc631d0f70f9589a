from onika.desk.plan.preparation import prepare_run
from onika.desk.plan.substitutes import with_substitutes
from onika.model.redirect import Redirect
from onika.store.site import open_site
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

SITE = open_site([], {}, None)


def helped(place, *redirects, application="go_home", remedies=()):
    chosen = tuple(map(Redirect.parse, redirects))
    fault = Fault(Place(str(place)), Reason.plain("a device"), Reason.plain("none"), "it is not run", remedies=remedies)
    (fault_helped,) = with_substitutes([fault], prepare_run(application, SITE, chosen), chosen, SITE)
    return fault_helped


def file_of(task):
    return SITE.home_of_task(task).task_file(task)


def test_a_task_that_cannot_live_as_it_is_is_told_with_those_that_could_stand_for_it():  # R-X02, R-E09
    fault = helped(file_of("puma"))
    assert {"redirect puma to puma_kin", "redirect puma to scara"} <= set(map(str, fault.remedies))
    assert "you can: redirect puma to" in str(fault)


def test_of_a_redirected_task_the_others_are_told_by_the_name_that_the_program_knows():  # R-X02
    fault = helped(file_of("puma_kin"), "puma=puma_kin")
    assert "redirect puma to scara" in map(str, fault.remedies)
    assert "redirect puma to puma_kin" not in map(str, fault.remedies)


def test_what_cannot_stand_there_is_not_offered():  # R-X02
    fault = helped(file_of("puma"), application="two_arms")
    assert "redirect puma to puma_right" not in map(str, fault.remedies)


def test_other_faults_stay_as_they_are():  # R-X02
    assert helped("go_home.appl").remedies == ()
    assert helped(file_of("puma"), remedies=("wait",)).remedies == ("wait",)
    assert helped(file_of("gripper")).remedies == ()
    nothing = prepare_run("nowhere", SITE)
    assert with_substitutes(nothing.faults, nothing, (), SITE) == list(nothing.faults)
