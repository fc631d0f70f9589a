BEGIN
  OPEN HAND opengripC
  DRIVE jmoveC TO box2_aj
  MOVE cmoveC TO box2_bx
  CLOSE HAND closegripC
  DRIVE jmoveC TO box2_aj
  DO holdsC
  CASE OF
    BEGIN
      OPEN HAND opengripC
    END
    BEGIN
      DRIVE jmoveC TO aside
    END
  END CASE
END
