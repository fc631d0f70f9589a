VERSION     2.0
DESC        a modular arm of four joints
FILE        foot.xml
LINKS       turn.xml bend.xml bend.xml turn.xml
ON          end

ARM         arm
TOOL        4.end
SPEED       1.5 1.5 1.5 1.5

EOF
