/** A name that no processing unit has yet, in the row of `rt0`, `rt1` … */
export function freeUnit(units: readonly string[]): string {
  let number = units.length
  while (units.includes(`rt${number}`)) number += 1
  return `rt${number}`
}
