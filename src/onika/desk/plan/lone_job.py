"""A job alone: a configuration planned as if an application had this one action, without a target."""

from onika.desk.plan.preparation import PreparedRun, prepare
from onika.model.application import AppFlow, Application, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.store.site import Site
from onika.words.fault import Fault, Place
from onika.words.reason import Reason


def lone_job(name: str, site: Site) -> PreparedRun | Fault:
    """The configuration of this name as a plan of one action, for who looks at it: nobody can run it as it is.

    A fault where there is no such configuration, or the syntax of icons cannot be read.
    """
    if site.configuration_file(name) is None:
        return Fault(Place(name), Reason.of("desk.configuration_unknown"), Reason.of("words.nothing_run"))
    syntax, faults = site.syntax()
    if syntax is None:
        return faults[0]
    onikon, _ = site.onikon(name, syntax)
    step = Icon(onikon or Onikon(name, "Job", name, (), blank()))
    return prepare(Application(name, False, (AppFlow((step,)),)), Place(name), site, syntax)
