"""A class on one machine: a seat for each learner, an environment of its own, and a board of all for the teacher."""
