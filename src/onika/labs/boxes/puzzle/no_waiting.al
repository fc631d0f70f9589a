COBEGIN
  BEGIN
    DRIVE jmoveC TO box1_aj
  END
  BEGIN
    DRIVE jmove_rightC TO box1_ajr
    DRIVE jmove_rightC TO aside
    OPEN HAND opengrip_rightC
  END
COEND
