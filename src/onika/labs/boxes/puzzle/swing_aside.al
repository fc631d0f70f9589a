BEGIN
  DRIVE jmoveC TO aside
END
