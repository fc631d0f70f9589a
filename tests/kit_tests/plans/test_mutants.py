from collections import Counter
from dataclasses import replace
from pathlib import Path

import onika
from kit.plans.mutants import mutants
from onika.files import appl
from onika.store.site import open_site

SYNTAX = open_site([], {}, None).syntax()[0]
TEXT = (Path(onika.__file__).parent / "labs" / "boxes" / "appl" / "assemble.appl").read_text()
ASSEMBLE = appl.read(TEXT, "assemble", "assemble.appl", SYNTAX)[0]


def test_every_kind_of_mistake_is_made_at_every_place():  # R-X07
    counter = Counter(mutant.kind.partition(" ")[0] for mutant in mutants(ASSEMBLE, SYNTAX))
    assert counter == {"missing": 25, "doubled": 25, "swapped": 24, "wrong": 18, "changed": 18}


def test_a_mutant_differs_from_the_program_and_can_be_written():  # R-X07
    for at, mutant in enumerate(mutants(ASSEMBLE, SYNTAX)):
        assert mutant.application != ASSEMBLE
        if at % 10 == 0:
            assert appl.read(appl.write(mutant.application), "assemble", "a.appl", SYNTAX) == (mutant.application, ())


def test_another_robot_takes_one_action_or_all():  # R-X07
    jobs = {step.onikon.name: step.onikon for step in ASSEMBLE.flows[0].steps if step.onikon.name.endswith("C")}
    others = {name: replace(job, name=f"{name[:-1]}_rightC") for name, job in jobs.items()}
    wrong = [mutant for mutant in mutants(ASSEMBLE, SYNTAX, others) if mutant.kind == "wrong robot"]
    assert len(wrong) == 26
    names = [step.onikon.name for step in wrong[-1].application.flows[0].steps]
    assert not set(jobs) & set(names)
