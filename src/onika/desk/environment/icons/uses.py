"""Where an icon of a dictionary is placed: in the applications that could be opened, and in those that are open."""

from pathlib import Path

from onika.desk.environment.state.model import Model
from onika.model.application import Application, Icon, every_flow
from onika.model.onikon import Onikon
from onika.model.syntax import same_type
from onika.store.base_directory import BaseDirectory


def users_of(model: Model, onikon: Onikon) -> tuple[str, ...]:
    """The names of the applications, each once: as they are here where they are open, else as their files say."""
    here = {str(application.opened.path) for application in model.applications.values() if application.opened}
    names = [application.name for application in model.applications.values() if _has(application.application, onikon)]
    for path, file in model.application_files.items():
        if path not in here and model.syntax is not None:
            read, _ = BaseDirectory(Path(file.base)).application(file.name, model.syntax)
            names += [file.name] if read is not None and _has(read, onikon) else []
    return tuple(dict.fromkeys(names))


def _has(application: Application, onikon: Onikon) -> bool:
    steps = (step for _, flow in every_flow(application) for step in flow.steps)
    return any(
        isinstance(step, Icon) and step.onikon.name == onikon.name and same_type(step.onikon.type, onikon.type)
        for step in steps
    )
