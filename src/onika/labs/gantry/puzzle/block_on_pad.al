BEGIN
  DO gripper_gantryC TO open_wide
  DRIVE jmove_gantryC TO over_block
  DRIVE jmove_gantryC TO at_block
  DO gripper_gantryC TO on_block
  DRIVE jmove_gantryC TO over_block
  DRIVE jmove_gantryC TO over_pad
  DRIVE jmove_gantryC TO at_pad
  DO gripper_gantryC TO open_wide
END
