BEGIN
  OPEN HAND opengripC
  MOVE cmove_scaraC TO over_box3
  MOVE cmove_scaraC TO box3_bx
  CLOSE HAND closegripC
  MOVE cmove_scaraC TO over_box3
END
