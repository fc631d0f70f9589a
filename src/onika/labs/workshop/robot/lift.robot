VERSION     2.0
DESC        a table that rises and turns
FILE        lift.xml

AXES        axes
MOVES       rise turn

EOF
