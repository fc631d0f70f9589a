BEGIN
  DRIVE jmoveC TO box2_aj
  REPEAT up
    MOVE cshiftC TO up_10cm
    DO repeatC TO three
  UNTIL DONE
END
