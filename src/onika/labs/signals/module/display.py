"""Joint positions on an outside display."""

from onika.module import InConst, InVar, Local, Module, Partner


class Display(Module):
    """Shows joint positions as they are, on a display outside: a terminal, a page, another machine.

    Kind     passive, synchronous, 1..100 Hz
    Ports    INCONST  NDOF   int           -    number of joints
             INVAR    Q_MEZ  double[NDOF]  rad  what is shown
    Local    PARTNER         line          -    where the display listens: unix:PATH or tcp:HOST:PORT
             STARTS          line          -    what starts the display, if the task is to do that
             PATIENCE        double        s    how long the display may take to answer
    Errors   no answer       warns and goes off
    Source   dissertation §5.8.3
    """

    passive = True

    NDOF = InConst("int", "-", "number of joints")
    Q_MEZ = InVar("double[NDOF]", "rad", "what is shown")

    PARTNER = Local("line", "-", "where the display listens: unix:PATH or tcp:HOST:PORT", default="")
    STARTS = Local("line", "-", "what starts the display, if the task is to do that", default="")
    PATIENCE = Local("double", "s", "how long the display may take to answer", default=1.0, low=0.001, high=3600.0)

    def init(self):
        self.partner = Partner(self.PARTNER, self.STARTS, self.PATIENCE)

    def cycle(self):
        self.partner.ask("show", t=self.now, unit="rad", values={"Q_MEZ": self.Q_MEZ})
