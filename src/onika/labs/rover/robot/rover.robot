VERSION     2.0
DESC        a rover on two wheels, with an eye in front
FILE        rover.xml

BASE        base
# the radius of a wheel, and how far they stand apart
WHEELS      left right 0.06 0.26
SPEED       0.6 2.5

CAMERA      eye

EOF
