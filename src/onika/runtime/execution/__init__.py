"""Tasks are executed on a processing unit: their lives, their cycles, what is asked of them."""
