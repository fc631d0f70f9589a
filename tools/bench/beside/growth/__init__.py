"""How Onika grows: with tasks on a unit, with processing units, with files in a library."""
