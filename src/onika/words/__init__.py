"""Ground floor: values, types, shapes, names, faults, reasons and their sentences. Knows nothing of tasks or robots."""
