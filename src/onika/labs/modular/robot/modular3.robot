VERSION     2.0
DESC        a modular arm of three joints
FILE        foot.xml
LINKS       turn.xml bend.xml bend.xml
ON          end

ARM         arm
TOOL        3.end
SPEED       1.5 1.5 1.5

EOF
