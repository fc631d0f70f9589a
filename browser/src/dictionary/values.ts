// The values of a target as a form of words, one for each element of each item.
import type { AskView, ItemView } from '../api.gen'
import { fields, first, type Field } from '../question/question'

export type Nested = readonly (readonly string[])[]

/** The items as a question's; what is known of the present goes with it. */
export function askOf(items: readonly ItemView[] | undefined, present?: AskView['present']): AskView {
  return {
    items: (items ?? []).map((item) => ({ ...item, unit: item.unit ?? '', meaning: item.meaning ?? '' })),
    present,
  }
}

/** The words that a form begins with: those that are there already, else what an item begins with. */
export function begun(rows: readonly Field[], values?: Nested): string[] {
  if (!values?.length) return rows.map(first)
  const words = values.flat()
  return rows.map((row, k) => words[k] ?? first(row))
}

/** The words of every item, in the order of its type. */
export function nested(rows: readonly Field[], words: readonly string[]): string[][] {
  const items = [...new Set(rows.map((row) => row.item))]
  return items.map((item) => rows.flatMap((row, k) => (row.item === item ? [words[k] ?? ''] : [])))
}

export const rowsOf = (ask: AskView): Field[] => fields(ask)

/** What each element is called: its place, or the word of the meaning for it where that names all of them. */
export function labelOf({ item, index }: Field): string {
  if (item.count === 1) return item.name
  const names = (item.meaning ?? '')
    .replace(/^.*:/, '')
    .split(/[,;]/)
    .map((name) => name.trim())
  return names.length === item.count && names.every((name) => name.length > 0 && name.length <= 12)
    ? names[index]!
    : `[${index}]`
}

/** A number of radians in degrees, for reading; empty where it is none. */
export function degrees(word: string, unit: string): string {
  const value = Number(word)
  if (unit !== 'rad' || !word.trim() || !Number.isFinite(value)) return ''
  return `${String(Number(((value * 180) / Math.PI).toFixed(1))).replace('-', '−')}°`
}

/** What was measured as words of the form; those that nothing measures stay as they are. */
export function taken(
  rows: readonly Field[],
  words: readonly string[],
  values: Readonly<Record<string, readonly number[]>>,
): string[] {
  return rows.map(({ item, index }, k) => {
    const value = values[item.name]?.[index]
    return value === undefined ? (words[k] ?? '') : tidy(value, values[item.name]!)
  })
}

/** A measured number without the dust of its last places: seven digits of the largest of its vector. */
function tidy(value: number, all: readonly number[]): string {
  const largest = Math.max(...all.map(Math.abs))
  if (!largest) return '0'
  const places = Math.max(0, Math.min(20, 6 - Math.floor(Math.log10(largest))))
  return String(Number(value.toFixed(places)) || 0)
}

/** Whether it is of a pose, which says where an arm's tool goes. */
export const isOfPose = ({ item }: Field): boolean => 'place' in item && item.place === 'pose'

/** How the tool of a pose is turned about its approach; undefined where no pose is filled in. */
export function normalOf(rows: readonly Field[], words: readonly string[]): [number, number, number] | undefined {
  const pose = rows.flatMap((row, k) => (isOfPose(row) ? [words[k] ?? ''] : []))
  const [x = NaN, y = NaN, z = NaN] = pose.slice(3, 6).map((word) => (word.trim() ? Number(word) : NaN))
  return Number.isFinite(x + y + z) && Math.hypot(x, y, z) > 0 ? [x, y, z] : undefined
}

/** The names of the items that were not measured: what a taught target still lacks (D23). */
export function lacking(rows: readonly Field[], values: Readonly<Record<string, readonly number[]>>): string[] {
  return [...new Set(rows.map((row) => row.item.name))].filter((name) => !(name in values))
}
