"""Ground floor: values and their types, shapes, names, faults. Knows nothing of tasks or robots."""
