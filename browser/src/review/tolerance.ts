// How far two recorded runs may lie apart, as it is typed.

export const TOLERANCES = ['tolerance', 'part', 'time_s'] as const
export type Tolerance = (typeof TOLERANCES)[number]

/** As it is typed at first. */
export const NONE: Record<Tolerance, string> = { tolerance: '0', part: '0', time_s: '0' }

/** What is typed as numbers; what is no number counts as none. */
export const valuesOf = (typed: Record<Tolerance, string>): Record<Tolerance, number> => ({ tolerance: read(typed.tolerance) ?? 0, part: read(typed.part) ?? 0, time_s: read(typed.time_s) ?? 0 })

/** The number in a text, with a point or a comma; undefined where it is none, or less than nothing. */
export function read(text: string): number | undefined {
  const plain = text.trim().replace(',', '.')
  const value = plain === '' ? 0 : Number(plain)
  return Number.isFinite(value) && value >= 0 ? value : undefined
}
