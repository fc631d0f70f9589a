VERSION     2.0
DESC        a plate on six legs
FILE        stewart.xml

AXES        legs
MOVES       leg0 leg1 leg2 leg3 leg4 leg5

# where the model has the plate, to compare with what the legs say
SENSOR      plate
POSE        plate

EOF
