"""A mesh in COLLADA (DAE) as one in Wavefront OBJ, which MuJoCo reads (requirement X19).

Lengths are made metres as the file says its unit. The axis that points up is left as it is: robots are described in
the frame of their mesh, whatever its file says of up, and so do the viewers that people use show them.
"""

import warnings
from functools import lru_cache
from importlib.util import find_spec
from io import BytesIO
from typing import TYPE_CHECKING, Any

from onika.words.reason import Reason

ENDING = ".dae"
EXTRA = "collada"
"""What is installed to read them: `pip install 'onika[collada]'`."""

_KEPT = 16
"""Meshes that are made once: the files of a world are gathered whenever a plan is made."""

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Corners = npt.NDArray[np.float64]


def can_read() -> bool:
    """Whether what reads them is installed."""
    return find_spec("collada") is not None


@lru_cache(_KEPT)
def obj_of(content: bytes) -> bytes:
    """The triangles of all its shapes, where its scene has them; raises ValueError where there are none to be read."""
    import collada  # it and NumPy are heavy, and seldom wanted
    import numpy as np

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", PendingDeprecationWarning)  # it makes matrices of an old kind
            document = collada.Collada(BytesIO(content), ignore=[collada.DaeError])
            shapes = [_triangles(primitive) for primitive in _primitives(document)]
    except Exception as wrong:  # of what stands in a file whatever reads it may stumble over anything
        raise ValueError(Reason.of("store.collada_unreadable", why=str(wrong))) from None
    corners = [shape for shape in shapes if len(shape)]
    if not corners:
        raise ValueError(Reason.of("store.collada_empty"))
    metres = float(document.assetInfo.unitmeter or 1.0)
    return _obj(np.concatenate(corners) * metres)


def _primitives(document: Any) -> list[Any]:
    """The primitives of all shapes, where the scene places them; of a document without a scene, where they are made."""
    if document.scene is None:
        return [primitive for geometry in document.geometries for primitive in geometry.primitives]
    return [primitive for shape in document.scene.objects("geometry") for primitive in shape.primitives()]


def _triangles(primitive: Any) -> "Corners":
    """The corners of its triangles, double[n,3,3]; of lines none."""
    import numpy as np

    made = primitive.triangleset() if hasattr(primitive, "triangleset") else primitive
    if getattr(made, "vertex_index", None) is None or np.shape(made.vertex_index)[-1] != 3:
        return np.empty((0, 3, 3))
    corners: Corners = np.asarray(made.vertex, dtype=float)[np.asarray(made.vertex_index)]
    return corners


def _obj(triangles: "Corners") -> bytes:
    import numpy as np

    corners, numbers = np.unique(triangles.reshape(-1, 3).astype(np.float32), axis=0, return_inverse=True)
    faces = np.reshape(numbers, (-1, 3)) + 1
    rows = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in corners.tolist()]
    rows += [f"f {a} {b} {c}" for a, b, c in faces.tolist()]
    return "\n".join([*rows, ""]).encode()
