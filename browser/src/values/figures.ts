// The columns of the status view (§A.5) and how their figures are written.

/** A figure as it is shown: its number, and behind it a small unit. */
export interface Shown {
  text: string
  unit: string
}

export const COLUMNS = [
  'rmod',
  'rtpu',
  'tid',
  'S',
  'crit',
  'state',
  'cycle',
  'miss',
  'ref-F',
  'ref-T',
  'mez-F',
  'mez-T',
  'ptime',
  'tot-C',
  'tick',
  'min-U',
  'max-U',
  'avg-U',
  'min-C',
  'max-C',
  'avg-C',
  'warn',
] as const

export type Column = (typeof COLUMNS)[number]

/** Columns of words stand to the left, those of numbers to the right. */
export const isText = (column: Column): boolean => ['rmod', 'rtpu', 'S', 'state'].includes(column)

const NONE: Shown = { text: '–', unit: '' }

/** A figure in words: shares as per cent, times in ms or µs, whole numbers in groups of three. */
export function written(column: Column, value: unknown): Shown {
  if (typeof value === 'string' && value) return { text: value, unit: '' }
  if (typeof value !== 'number' || !Number.isFinite(value)) return NONE
  if (column.endsWith('-F')) return { text: trimmed(value, 1), unit: 'Hz' }
  if (column.endsWith('-U')) return { text: (value * 100).toFixed(1), unit: '%' }
  if (column === 'ptime') return { text: value.toFixed(1), unit: 's' }
  if (column.endsWith('-C') || column.endsWith('-T') || column === 'tick') return time(value)
  return { text: grouped(value), unit: '' }
}

/** A time that is given in milliseconds. */
function time(ms: number): Shown {
  if (ms !== 0 && Math.abs(ms) < 1) return { text: (ms * 1000).toFixed(Math.abs(ms) < 0.01 ? 1 : 0), unit: 'µs' }
  return { text: trimmed(ms, 2), unit: 'ms' }
}

function trimmed(value: number, digits: number): string {
  return Number.isInteger(value) ? grouped(value) : value.toFixed(digits)
}

function grouped(value: number): string {
  return String(value).replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f') // a narrow blank that does not break
}

/** Rows by a column: numbers by size, words by alphabet, what is missing last. */
export function compare(a: unknown, b: unknown): number {
  const [none, other] = [a === undefined || a === '', b === undefined || b === '']
  if (none || other) return Number(none) - Number(other)
  if (typeof a === 'number' && typeof b === 'number') return a - b
  return String(a).localeCompare(String(b), undefined, { numeric: true })
}
