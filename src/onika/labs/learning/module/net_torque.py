"""Torque as a neural network has learnt it."""

from importlib import resources
from pathlib import Path

import numpy as np

from onika.module import InConst, InVar, Local, Module, ModuleError, OutVar


class NetTorque(Module):
    """A neural network in an ONNX file, which gives each joint a torque for every posture.

    The network takes float[1,NDOF], the joints in rad, and gives float[1,NDOF], torques in N m. It is carried out in
    the cycle, by one thread. It was taught elsewhere, and learns nothing here.

    Kind     general, periodic, 20..1000 Hz
    Ports    INCONST  NDOF    int           -    number of joints
             INCONST  TAUMAX  double[NDOF]  N m  highest joint torques
             INVAR    Q_MEZ   double[NDOF]  rad  measured position
             OUTVAR   TAU_G   double[NDOF]  N m  the torque, never more than TAUMAX
    Local    MODEL            string        -    path of the ONNX file, from / or ~ on, or in a laboratory
    Errors   no network       it cannot be read, is for another number of joints, or nothing that reads it is installed
             no number        it gives something that is none: ERROR
    Source   J. M. Mendel & K. S. Fu (eds.), paper III of the source; https://onnx.ai
    """

    NDOF = InConst("int", "-", "number of joints")
    TAUMAX = InConst("double[NDOF]", "N m", "highest joint torques")
    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    TAU_G = OutVar("double[NDOF]", "N m", "the torque, never more than TAUMAX")

    MODEL = Local("string", "-", "path of the ONNX file, from / or ~ on, or in a laboratory", default="")

    def init(self):
        path = self._path()
        try:
            import onnxruntime
        except ImportError:
            raise ModuleError("expected onnxruntime, which reads networks: pip install 'onika[onnx]'") from None
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        options.log_severity_level = 4
        try:
            self._net = onnxruntime.InferenceSession(path.read_bytes(), options, providers=["CPUExecutionProvider"])
        except Exception as wrong:  # what it raises is of no common kind
            raise ModuleError("expected a network in {path}: {why}", path=str(path), why=str(wrong)) from None
        (self._input,), (output,) = self._net.get_inputs(), self._net.get_outputs()
        if [self._input.shape, output.shape] != [[1, self.NDOF]] * 2:
            raise ModuleError(
                "expected a network from {count} joints to as many torques, found {found}",
                count=self.NDOF,
                found=f"{self._input.shape} -> {output.shape}",
            )
        self._posture = np.zeros((1, self.NDOF), np.float32)
        self.cycle()  # the first time takes longer: here, not when the task comes on

    def _path(self):
        """Where the file lies: one's own comes before what is shipped."""
        own, shipped = Path.home() / "onika", Path(str(resources.files("onika"))) / "labs"
        path = own / Path(self.MODEL).expanduser()  # a path from the root on stays what it is
        if path.exists() or not path.is_relative_to(own):
            return path
        return shipped / path.relative_to(own)

    def on(self, inputs):
        self.cycle()

    def cycle(self):
        self._posture[0] = self.Q_MEZ
        torque = self._net.run(None, {self._input.name: self._posture})[0][0]
        if not np.isfinite(torque).all():
            raise ModuleError("expected numbers from the network, found {found}", found=str(torque))
        self.TAU_G = np.clip(torque, -self.TAUMAX, self.TAUMAX)
