COBEGIN
  BEGIN
    SYNCH free
    DRIVE jmoveC TO box1_aj
  END
  BEGIN
    DRIVE jmove_rightC TO box1_ajr
    DRIVE jmove_rightC TO aside
    SYNCH free
    OPEN HAND opengrip_rightC
  END
COEND
