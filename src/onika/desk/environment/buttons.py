"""The user's own buttons and the commands behind them; only what their file says is ever run (G02, §5.7.2)."""

from dataclasses import replace

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.restoration import own_step
from onika.files import buttons as file
from onika.model.button import Button
from onika.store.opened_text import OpenedText
from onika.wire import act, page
from onika.wire.view import ButtonView, Remedy
from onika.words.fault import Refusal
from onika.words.reason import Reason


def press(model: Model, command: act.Press, outside: Services) -> Done | No:
    """Run the command of a button; what it prints is shown while it runs."""
    button = _find(model, command.name)
    if button is None:
        return No(Reason.of("run.no_button", name=command.name))
    if _is_running(model, command.name):
        return _running(command.name)
    if outside.commands is None:
        return No(Reason.of("run.no_commands"))
    started = outside.commands.start(button)
    if isinstance(started, Refusal):
        return No(Reason.of("run.command_not_run", name=command.name, why=started.reason))
    running = ButtonView("", 0, is_running=True)
    says = (page.Say("info", started),) if started else ()
    return Done(replace(model, runs={**model.runs, command.name: running}), says=says)


def halt(model: Model, command: act.Halt, outside: Services) -> Done | No:
    """End a command with everything it has begun; that it has ended is a fact that comes later."""
    if outside.commands is None or not outside.commands.halt(command.name):
        return No(Reason.of("run.command_not_running", name=command.name))
    return Done(model)


def set_button(model: Model, command: act.SetButton, outside: Services) -> Done | No:
    """Add a button, change it, or remove it where the command is empty; it is in the user's file at once."""
    name = " ".join(command.name.split())
    button = Button(name, command.command.strip(" \t"), command.spawns_terminal)
    wrong = _wrong(button)
    if wrong:
        return No(Reason.of("run.together", parts=tuple(wrong.values())), fields=wrong)
    if not button.command and _is_running(model, name):
        return _running(name)
    opened, faults = outside.site.open_buttons()
    if opened is None and faults:
        return No(Reason.of("run.buttons_left", faults=tuple(fault.sentence for fault in faults)))
    former = opened.value if opened else ()
    done = _saved(model, _changed(former, button), opened, outside)
    if isinstance(done, No):
        return done
    there = next((other for other in former if other.name == name), Button(name, "", False))
    step = own_step(Reason.of("run.changing_button", name=name), _setting(there), _setting(button))
    return replace(done, own=step if there != button else None)


def _setting(button: Button) -> act.SetButton:
    return act.SetButton(button.name, button.command, button.spawns_terminal)


def _find(model: Model, name: str) -> Button | None:
    return next((button for button in model.buttons if button.name == name), None)


def _is_running(model: Model, name: str) -> bool:
    return name in model.runs and model.runs[name].is_running


def _running(name: str) -> No:
    """A command that runs has to end first."""
    halt = Remedy(Reason.of("run.halt_command", name=name), act.Halt(name))
    return No(Reason.of("run.command_running", name=name), (halt,))


def _wrong(button: Button) -> dict[str, Reason]:
    """What is wrong with a button, by field: the file must say the same of it again."""
    if not button.name:
        return {"name": Reason.of("run.button_unnamed")}
    if not button.command:
        return {}
    read, _ = file.read(file.write((button,)), file.NAME, file.NAME)
    if read == (button,):
        return {}
    if read and read[0].name == button.name:
        return {"command": Reason.of("run.button_command")}
    return {"name": Reason.of("run.button_name")}


def _changed(buttons: tuple[Button, ...], button: Button) -> tuple[Button, ...]:
    """With the button in its place, or at the end where it is new; without it where it has no command."""
    if not button.command:
        return tuple(other for other in buttons if other.name != button.name)
    names = [button.name for button in buttons]
    if button.name not in names:
        return (*buttons, button)
    place = names.index(button.name)
    return (*buttons[:place], button, *buttons[place + 1 :])


def _saved(
    model: Model, buttons: tuple[Button, ...], opened: OpenedText[tuple[Button, ...]] | None, outside: Services
) -> Done | No:
    done = outside.site.save_buttons(buttons, opened)
    if isinstance(done, Refusal):
        return No(done.reason)
    names = {button.name for button in buttons}
    runs = {name: run for name, run in model.runs.items() if name in names}
    return Done(replace(model, buttons=buttons, runs=runs))
