// Drawn from src/onika/words/unit.py by tools/generate.py: change that.
export const UNITS: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  "angle_unit": {
    "rad": 1.0,
    "deg": 57.29577951308232
  },
  "length_unit": {
    "m": 1.0,
    "cm": 100.0,
    "mm": 1000.0
  }
};
export const RATES: readonly string[] = ["", "/s", "/s^2"];
