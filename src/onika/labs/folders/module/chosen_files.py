"""The files that are chosen."""

from onika.module import InVar, Module, OutVar


class ChosenFiles(Module):
    """Keeps from one job to the next which files of which folder are chosen.

    Kind     passive, periodic, 1..100 Hz
    Ports    INVAR  NEXT_FOLDER  line         -  the folder that the last job chose from
             INVAR  NEXT_FILES   byte[65536]  -  the names that it chose, in UTF-8, a slash behind each, then zeros
             OUTVAR FOLDER       line         -  the folder
             OUTVAR FILES        byte[65536]  -  the names of the files in it that are chosen, written alike
             OUTVAR COUNT        int          -  how many they are
    Source   dissertation §7
    """

    passive = True

    NEXT_FOLDER = InVar("line", "-", "the folder that the last job chose from")
    NEXT_FILES = InVar("byte[65536]", "-", "the names that it chose, in UTF-8, a slash behind each, then zeros")
    FOLDER = OutVar("line", "-", "the folder")
    FILES = OutVar("byte[65536]", "-", "the names of the files in it that are chosen, written alike")
    COUNT = OutVar("int", "-", "how many they are")

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        self.FOLDER, self.FILES = self.NEXT_FOLDER, self.NEXT_FILES
        self.COUNT = bytes(self.NEXT_FILES).count(b"/")
