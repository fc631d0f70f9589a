// A value as it is read: nobody reads seven places of an angle. Who edits it sees all of them.

const NUMBER = /^[+-]?\d*\.\d+(e[+-]?\d+)?$/i
const DIGITS = 4

/** Four digits of a number, more where it has more before its point; other words as they are. */
export function short(word: string): string {
  const value = Number(word)
  if (!NUMBER.test(word.trim()) || !Number.isFinite(value)) return word
  const whole = Math.trunc(Math.abs(value))
  const rounded = String(Number(value.toPrecision(Math.max(DIGITS, whole ? String(whole).length : 0))))
  return rounded.length < word.trim().length ? rounded : word
}
