"""Joint positions and references in a log that an outside program keeps."""

from onika.module import InConst, InVar, Local, Module, ModuleError, Partner


class Logger(Module):
    """Has an outside program write down where the arm is and where it should be; every row is acknowledged.

    Kind     passive, synchronous, 1..100 Hz
    Ports    INCONST  NDOF   int           -    number of joints
             INVAR    Q_MEZ  double[NDOF]  rad  measured position
             INVAR    Q_REF  double[NDOF]  rad  reference position
    Local    PARTNER         line          -    where the logger listens: unix:PATH or tcp:HOST:PORT
             STARTS          line          -    what starts the logger, if the task is to do that
             PATIENCE        double        s    how long the logger may take to answer
    Errors   no answer       warns and goes off
    Get/Set  rows, how many the logger has written / -
    Source   dissertation §5.8.3
    """

    passive = True

    NDOF = InConst("int", "-", "number of joints")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    Q_REF = InVar("double[NDOF]", "rad", "reference position")

    PARTNER = Local("line", "-", "where the logger listens: unix:PATH or tcp:HOST:PORT", default="")
    STARTS = Local("line", "-", "what starts the logger, if the task is to do that", default="")
    PATIENCE = Local("double", "s", "how long the logger may take to answer", default=1.0, low=0.001, high=3600.0)

    def init(self):
        self.partner = Partner(self.PARTNER, self.STARTS, self.PATIENCE)
        self._rows = 0

    def cycle(self):
        self.partner.ask("log", t=self.now, row=[*self.Q_MEZ, *self.Q_REF])

    def sync(self):
        rows = int(self.partner.answer.number("rows", 0, 2**53))
        if rows <= self._rows:
            raise ModuleError("expected more than {rows} rows in the log, found {count}", rows=self._rows, count=rows)
        self._rows = rows

    def on(self, inputs):
        self._rows = 0

    def get(self, name):
        return self._rows if name == "rows" else super().get(name)
