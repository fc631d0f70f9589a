"""A guest: a program of another framework, which carries out the actions of a flow."""

from onika.module import Local, Module, ModuleError, Partner


class GuestKeeper(Module):
    """Starts a guest, keeps it as long as its flow lives, and finds out when it is gone or says nothing.

    It stands beside the tasks that ask the guest for actions, in each of their configurations, and is the same there:
    so it goes on from action to action.

    Kind     general, synchronous, 1..10 Hz
    Local    GUEST     string  -  name that the guest says of itself
             PARTNER   line    -  where the guest listens: unix:PATH or tcp:HOST:PORT
             STARTS    line    -  what starts the guest, if the task is to do that
             PATIENCE  double  s  how long the guest may say nothing
    Errors   gone, silent    ERROR, which stops the flow
             another name    somebody else listens there: ERROR
    Source   Gertz and Khosla, section III
    """

    GUEST = Local("string", "-", "name that the guest says of itself")
    PARTNER = Local("line", "-", "where the guest listens: unix:PATH or tcp:HOST:PORT")
    STARTS = Local("line", "-", "what starts the guest, if the task is to do that", default="")
    PATIENCE = Local("double", "s", "how long the guest may say nothing", default=5.0, low=0.001, high=3600.0)

    def init(self):
        self.partner = Partner(self.PARTNER, self.STARTS, self.PATIENCE)
        self.partner.name = self.GUEST

    def cycle(self):
        self.partner.ask("hello")

    def sync(self):
        name = self.partner.answer.text("guest")
        if name != self.GUEST:
            raise ModuleError("expected the guest {expected}, found {name}", expected=self.GUEST, name=name)
