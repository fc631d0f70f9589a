"""A picture in a small form for whoever looks at it: JPEG where Pillow is installed, else PNG."""

from io import BytesIO

import numpy as np
import numpy.typing as npt

from onika.workcell.picture import png

_QUALITY = 80


def small_picture(pixels: npt.NDArray[np.uint8]) -> bytes:
    """The file of uint8[height,width,3]."""
    try:
        from PIL import Image
    except ImportError:
        return png(pixels, 1)
    file = BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=_QUALITY)
    return file.getvalue()
