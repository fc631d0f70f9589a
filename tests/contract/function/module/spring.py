"""A spring at each joint; stands for all modules that are made of a function."""

from onika.module import InConst, InVar, Local, OutVar, module


@module(hz=(20, 1000))
def spring(
    NDOF: InConst("int", "-", "number of joints"),
    Q_MEZ: InVar("double[NDOF]", "rad", "measured position"),
    QD_MEZ: InVar("double[NDOF]", "rad/s", "its rate", name="Q^_MEZ"),
    K: Local("double", "N m/rad", "stiffness") = 2.0,
) -> OutVar("double[NDOF]", "N m", "torque", name="TAU"):
    """Torque against the displacement: TAU = -K Q_MEZ - Q^_MEZ."""
    return -K * Q_MEZ - QD_MEZ if NDOF else None
