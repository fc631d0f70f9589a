// The preferences in groups a person would look in, and what is not in any of them.
import type { TextKey } from '../texts/index.svelte'
import { UNITS } from '../values/units.gen'

export type Value = boolean | number | string | string[]

export interface Field {
  name: string
  value: Value
}

const GROUPS: [TextKey, string[]][] = [
  ['levels.label', ['shows_lower']],
  ['prefer.icons', ['line_length', 'min_size', 'min_pin_separation', 'step_size', 'pin_length', 'shows_period']],
  [
    'prefer.wires',
    [
      'show_inconst',
      'show_outconst',
      'show_invar',
      'show_outvar',
      'connection_separation',
      'locus_size',
      'hit_tolerance',
    ],
  ],
  ['prefer.figures', ['status_columns', 'shows_warnings']],
  ['prefer.units', Object.keys(UNITS)],
  ['prefer.study', ['keeps_diary']],
]

/** How icons are presented is fixed by a study; nobody chooses it here. */
const FIXED = 'presentation'

/** What there is to choose from; undefined: it is no choice. */
export const choices = (name: string): string[] | undefined => (UNITS[name] ? Object.keys(UNITS[name]) : undefined)

export function grouped(preferences: Readonly<Record<string, unknown>>): [TextKey, Field[]][] {
  const grouped = new Set(GROUPS.flatMap(([, names]) => names))
  const others = Object.keys(preferences).filter((name) => !grouped.has(name) && name !== FIXED)
  return [...GROUPS, ['prefer.others', others] as [TextKey, string[]]]
    .map(([title, names]): [TextKey, Field[]] => [title, names.flatMap((name) => field(name, preferences[name]))])
    .filter(([, fields]) => fields.length > 0)
}

function field(name: string, value: unknown): Field[] {
  return isValue(value) ? [{ name, value }] : []
}

function isValue(value: unknown): value is Value {
  if (['boolean', 'number', 'string'].includes(typeof value)) return true
  return Array.isArray(value) && value.every((item) => typeof item === 'string')
}

/** What was typed, as a value of the same kind as before; undefined where it is none. */
export function typed(text: string, before: number | string | string[]): number | string | string[] | undefined {
  if (Array.isArray(before)) return text.split(/[\s,]+/).filter(Boolean)
  if (typeof before === 'string') return text
  const number = Number(text.replace(',', '.'))
  return text.trim() === '' || !Number.isFinite(number) ? undefined : number
}
