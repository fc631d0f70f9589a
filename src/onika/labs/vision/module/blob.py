"""The middle of a colour."""

from onika.laws.pictures.blob import ColourBlob
from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class Blob(Module):
    """Where in the picture the middle of all that has one colour is, however bright it is.

    u counts pixels to the right and v downwards, from the middle of the first pixel. Where nothing has the colour UV
    stays what it was, and AREA is 0.

    Kind     general, periodic, 1..100 Hz
    Ports    INCONST  H      int          -    height of a picture in pixels
             INCONST  W      int          -    width of a picture in pixels
             INVAR    IMG    byte[H,W,3]  -    the newest picture
             INVAR    IMG_T  double[2]    -,s  how many pictures there were; how old the newest is
             OUTVAR   UV     double[2]    -    the middle in pixels: to the right, down
             OUTVAR   AREA   double       -    how many pixels have the colour; 0: none, or fewer than LEAST
    Local    COLOUR          double[3]    -    red, green, blue
             CHROMA          double       -    how far from grey it is at least, of 255
             LEAST           double       -    fewer pixels count as none
    Errors   no colour       COLOUR is grey: stays uninitialised
    Source   dissertation §4.5.3
    """

    H = InConst("int", "-", "height of a picture in pixels")
    W = InConst("int", "-", "width of a picture in pixels")
    IMG = InVar("byte[H,W,3]", "-", "the newest picture")
    IMG_T = InVar("double[2]", "-,s", "how many pictures there were; how old the newest is")
    UV = OutVar("double[2]", "-", "the middle in pixels: to the right, down")
    AREA = OutVar("double", "-", "how many pixels have the colour; 0: none, or fewer than LEAST")

    COLOUR = Local("double[3]", "-", "red, green, blue", default=(1.0, 0.0, 0.0))
    CHROMA = Local("double", "-", "how far from grey it is at least, of 255", default=40.0, low=1.0, high=255.0)
    LEAST = Local("double", "-", "fewer pixels count as none", default=20.0, low=1.0)

    def init(self):
        try:
            self._blob = ColourBlob(self.COLOUR, self.CHROMA)
        except ValueError:
            raise ModuleError("COLOUR: expected a colour, found grey") from None

    def on(self, inputs):
        self._number = 0.0
        self.AREA = 0.0
        self.cycle()

    def cycle(self):
        if self.IMG_T[0] == self._number:
            return
        self._number = self.IMG_T[0]
        u, v, count = self._blob.middle(self.IMG)
        self.AREA = float(count) if count >= self.LEAST else 0.0
        if self.AREA:
            self.UV[0], self.UV[1] = u, v
