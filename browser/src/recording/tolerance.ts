// How far two recorded runs may lie apart, as it is typed.

export const TOLERANCES = ['tolerance', 'part', 'time_s'] as const
export type Tolerance = (typeof TOLERANCES)[number]

/** As it is typed at first: nothing, so that it is as runs of their kind do. */
export const NONE: Record<Tolerance, string> = { tolerance: '', part: '', time_s: '' }

/** Where what was typed last is kept; a part is typed in percent. */
export const KEPT = 'reviewTolerance'

/** A part in percent, without the noise of its last digits. */
export const percentOf = (part: number): number => +(100 * part).toFixed(3)

/** What is typed as numbers; what is nothing, or no number, is left to the environment. */
export function valuesOf(typed: Record<Tolerance, string>): Record<Tolerance, number | null> {
  const value = (text: string): number | null => (text.trim() ? (read(text) ?? null) : null)
  const percent = value(typed.part)
  return {
    tolerance: value(typed.tolerance),
    part: percent === null ? null : percent / 100,
    time_s: value(typed.time_s),
  }
}

/** The number in a text, with a point or a comma; undefined where it is none, or less than nothing. */
export function read(text: string): number | undefined {
  const plain = text.trim().replace(',', '.')
  const value = plain === '' ? 0 : Number(plain)
  return Number.isFinite(value) && value >= 0 ? value : undefined
}
