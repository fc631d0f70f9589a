VERSION     2.0
DESC        an arm of six joints that takes speeds
FILE        jointed.xml

ARM         arm
TOOL        tip
DRIVE       velocity
HOME        0 0.4 1.3 0 1.2 0
SPEED       2 2 2 3 3 3

EOF
