"""Teaches a small neural network the torque that holds a PUMA 560 against gravity, and writes it as an ONNX file.

Usage: python tools/learn_gravity.py FILE.onnx. It needs the package `onnx`, which nothing else here needs. What comes
out is src/onika/labs/learning/net/puma_gravity.onnx: sine and cosine of six joints, two layers of 48, six torques. It
is taught by backpropagation from 20,000 postures within the limits and the arm's own equations (`onika.laws.arm`).
"""

import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from onika.laws import puma560
from onika.laws.frames import Array
from onika.laws.textbook import serial_arm

POSTURES, STEPS, BATCH, WIDTH = 20_000, 15_000, 256, 48
RATE, FALL = 3e-3, 1e-2
"""Of the steps of Adam: the first, and what share of it is left at the end."""

Layers = list[tuple[Array, Array]]


def lessons(random: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Postures within the limits (rad), and the torques that hold the arm there (N m)."""
    arm = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD)
    postures = random.uniform(puma560.QMIN, puma560.QMAX, (count, puma560.NDOF))
    still = np.zeros(puma560.NDOF)
    return postures, np.array([arm.bias(posture, still) for posture in postures])


def outputs(layers: Layers, features: Array) -> list[Array]:
    """What each layer gives."""
    given = [features]
    for k, (weights, bias) in enumerate(layers):
        total = given[-1] @ weights + bias
        given.append(np.tanh(total) if k < len(layers) - 1 else total)
    return given


def slopes(layers: Layers, given: list[Array], error: Array) -> list[tuple[Array, Array]]:
    """How half the mean squared error grows with each weight and bias."""
    found: list[tuple[Array, Array]] = []
    for k in range(len(layers) - 1, -1, -1):
        found.insert(0, (given[k].T @ error / len(error), error.mean(axis=0)))
        error = (error @ layers[k][0].T) * (1.0 - given[k] ** 2)
    return found


def taught(postures: Array, wanted: Array, random: np.random.Generator) -> Layers:
    """Layers that give what is wanted, by Adam."""
    features = np.hstack([np.sin(postures), np.cos(postures)])
    sizes = [features.shape[1], WIDTH, WIDTH, wanted.shape[1]]
    layers: Layers = [
        (random.normal(0.0, ahead**-0.5, (ahead, behind)), np.zeros(behind)) for ahead, behind in pairwise(sizes)
    ]
    parts = [part for layer in layers for part in layer]
    means, squares = [np.zeros_like(part) for part in parts], [np.zeros_like(part) for part in parts]
    for step in range(1, STEPS + 1):
        chosen = random.integers(0, len(postures), BATCH)
        given = outputs(layers, features[chosen])
        rate = RATE * FALL ** (step / STEPS) * np.sqrt(1.0 - 0.999**step) / (1.0 - 0.9**step)
        slope_of_parts = [slope for pair in slopes(layers, given, given[-1] - wanted[chosen]) for slope in pair]
        for part, mean, square, slope in zip(parts, means, squares, slope_of_parts, strict=True):
            mean[...] += 0.1 * (slope - mean)
            square[...] += 0.001 * (slope * slope - square)
            part[...] -= rate * mean / (np.sqrt(square) + 1e-9)
    return layers


def written(layers: Layers, scale: Array, path: Path) -> None:
    """The network as an ONNX file; `scale` turns what it gives into N m."""
    import onnx
    from onnx import TensorProto, helper, numpy_helper

    def constant(name: str, values: Any) -> Any:
        return numpy_helper.from_array(np.asarray(values, np.float32), name)

    nodes = [
        helper.make_node("Sin", ["joints"], ["sine"]),
        helper.make_node("Cos", ["joints"], ["cosine"]),
        helper.make_node("Concat", ["sine", "cosine"], ["out0"], axis=1),
    ]
    constants = [constant("scale", scale)]
    for k, (weights, bias) in enumerate(layers):
        constants += [constant(f"w{k}", weights), constant(f"b{k}", bias)]
        nodes.append(helper.make_node("Gemm", [f"out{k}", f"w{k}", f"b{k}"], [f"sum{k + 1}"]))
        if k < len(layers) - 1:
            nodes.append(helper.make_node("Tanh", [f"sum{k + 1}"], [f"out{k + 1}"]))
    nodes.append(helper.make_node("Mul", [f"sum{len(layers)}", "scale"], ["torques"]))
    joints, torques = (
        helper.make_tensor_value_info(name, TensorProto.FLOAT, [1, len(scale)]) for name in ("joints", "torques")
    )
    graph = helper.make_graph(nodes, "puma_gravity", [joints], [torques], constants)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], producer_name="onika")
    model.ir_version = 8
    onnx.checker.check_model(model)
    path.write_bytes(model.SerializeToString())


def main(words: list[str]) -> None:
    """Teach it, say how well it has learnt, write it."""
    random = np.random.default_rng(560)
    postures, wanted = lessons(random, POSTURES)
    scale = wanted.std(axis=0) + 0.05
    layers = taught(postures, wanted / scale, random)
    postures, wanted = lessons(random, 2_000)
    found = outputs(layers, np.hstack([np.sin(postures), np.cos(postures)]))[-1] * scale
    print("mean and largest error by joint, N m:", np.abs(found - wanted).mean(axis=0).round(3), end=" ")
    print(np.abs(found - wanted).max(axis=0).round(2))
    written(layers, scale, Path(words[0]))


if __name__ == "__main__":
    main(sys.argv[1:])
