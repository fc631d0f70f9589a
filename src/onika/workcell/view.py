"""How a workcell is lit and from where it is looked at in a picture."""

CAMERA = "picture"
"""Name of the camera."""

LOOK = (
    '<visual><global offwidth="2560" offheight="1720" fovy="30"/><quality shadowsize="8192" offsamples="8"/>'
    '<headlight ambient="0.36 0.355 0.35" diffuse="0.12 0.12 0.12" specular="0.04 0.04 0.04"/>'
    '<rgba haze="0.972 0.963 0.942 1"/>'
    '<map znear="0.02" zfar="40" haze="0.6" shadowclip="1" shadowscale="0.9"/></visual>'
    '<statistic center="0.6 0 -0.2" extent="1.6"/>'
)
"""What a document that is drawn says first: fineness of the picture, soft daylight, paper at the horizon."""
