"""Ground floor: pure functions on arrays, equations and robots' tables, from which modules and worlds are made."""
