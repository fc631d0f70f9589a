BEGIN
  OPEN HAND opengripC
  DRIVE jmoveC TO box2_aj
  MOVE cmoveC TO HOLE
  CLOSE HAND closegripC
  DRIVE jmoveC TO box2_aj
END
