VERSION     2.0
DESC        a hand of three fingers that looks down
FILE        hand.xml

# of each finger in turn: all three aside, all three bent, all three curled
AXES        fingers
MOVES       aside0 aside1 aside2 bend0 bend1 bend2 curl0 curl1 curl2

EOF
