BEGIN
  OPEN HAND opengripC
  DRIVE jmoveC TO box2_aj
  MOVE cmoveC TO box2_bx
  CLOSE HAND closegripC
  DRIVE jmoveC TO box2_aj
END
