// Words of a form: kept in SI units, shown and typed in those that the user prefers, or in one that is typed behind them.
import { factorNamed, factorOf, scale } from '../values/units'
import { isNumber, type Field } from './question'

const DIGITS = 10
const SHOWN = 12
const TYPED = /^\s*([+\-−]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\d\s].*?)?\s*$/
const DUST = 1e-9

/** The row as it is shown: bounds and present value in the unit that is read. */
export function shownRow(row: Field): Field {
  const factor = factorIn(row)
  const of = scale(row.item.unit, `[${row.item.count}]`)
  if (of.isPlain) return row
  const present = row.present === undefined ? undefined : row.present * factor
  return { ...row, low: row.low * factor, high: row.high * factor, present }
}

/** The unit in which a row is read. */
export function unitOf(row: Field): string {
  const names = scale(row.item.unit, `[${row.item.count}]`).name.split(',')
  return names[names.length === 1 ? 0 : row.index] ?? ''
}

/** A word in SI units as it is shown; what is no number, as it is. */
export function shownWord(word: string, row: Field): string {
  const factor = factorIn(row)
  const value = Number(word)
  if (factor === 1 || !word.trim() || !Number.isFinite(value)) return word
  return String(Number((value * factor).toPrecision(SHOWN)))
}

/** What was typed as a word in SI units; what is no number, as it is. A unit behind it counts more than the preferred one. */
export function filedWord(text: string, row: Field): string {
  const match = isNumber(row.item.type) ? TYPED.exec(text) : null
  if (!match) return text
  const named = match[2] ? factorNamed(match[2], row.item.unit) : factorIn(row)
  if (named === undefined) return text
  const typed = match[1]!.replace('−', '-')
  if (named === 1) return match[2] ? typed : text
  const value = Number((Number(typed) / named).toPrecision(DIGITS))
  return String(inside(value, row))
}

/** What only the conversion has carried beyond a bound is at the bound. */
function inside(value: number, { low, high }: Field): number {
  const near = (bound: number): boolean => Math.abs(value - bound) <= DUST * Math.max(1, Math.abs(bound))
  if (value < low && near(low)) return low
  return value > high && near(high) ? high : value
}

const factorIn = (row: Field): number =>
  isNumber(row.item.type) ? factorOf(scale(row.item.unit, `[${row.item.count}]`), row.index) : 1
