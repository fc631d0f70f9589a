// Values as people read them: files, links and the log of numbers stay in SI units, whatever is preferred here (G08).
import { desk } from '../link/desk.svelte'
import type { Stretch } from './series'
import { RATES, UNITS } from './units.gen'

/** A unit as it is read, and by what SI values are multiplied: one number for all, or one for each element. */
export interface UnitScale {
  name: string
  factors: readonly number[]
  isPlain: boolean
}

type Choices = Readonly<Record<string, unknown>>

/** How values of a unit, or of a list of units as in `m,m/s,N`, are read where these are preferred. */
export function scaleOf(unit: string, choices: Choices, count = 1): UnitScale {
  const parts = unit.split(',').map((part) => partOf(part.trim(), choices))
  const factors = parts.map(([, factor]) => factor)
  // A list that does not name the unit of each element says nothing of any of them.
  if (parts.length > 1 && parts.length !== count) return { name: unit, factors: [1], isPlain: true }
  return { name: parts.map(([name]) => name).join(','), factors, isPlain: factors.every((factor) => factor === 1) }
}

function partOf(unit: string, choices: Choices): [string, number] {
  for (const [preference, units] of Object.entries(UNITS)) {
    const [filed] = Object.keys(units)
    const chosen = String(choices[preference] ?? '')
    if (filed === undefined || !unit.startsWith(filed) || !RATES.includes(unit.slice(filed.length))) continue
    const factor = units[chosen]
    if (factor !== undefined) return [chosen + unit.slice(filed.length), factor]
  }
  return [unit, 1]
}

/** The same for what this user prefers; `shape` as in `double[3]` says how many elements there are. */
export const scale = (unit: string | undefined, shape = ''): UnitScale =>
  scaleOf(unit ?? '', desk.tree.preferences, Number(/\[(\d+)\]$/.exec(shape)?.[1] ?? 1))

export const factorOf = ({ factors }: UnitScale, element: number): number =>
  factors[factors.length === 1 ? 0 : element] ?? 1

/** A value as it is read: numbers, and lists of them element by element; other values as they are. */
export function shownValue(value: unknown, of: UnitScale): unknown {
  if (of.isPlain) return value
  if (typeof value === 'number') return value * factorOf(of, 0)
  if (!Array.isArray(value)) return value
  if (of.factors.length === 1) return value.map((element) => shownValue(element, of))
  return value.map((element, k) => (typeof element === 'number' ? element * factorOf(of, k) : element))
}

/** A stretch of the past as it is read. */
export function shownStretch(stretch: Stretch, factors: readonly number[]): Stretch {
  if (factors.every((factor) => factor === 1)) return stretch
  return {
    t: stretch.t,
    y: stretch.y.map((column, k) => {
      const factor = factors[k] ?? 1
      return factor === 1 ? column : column.map((value) => value * factor)
    }),
  }
}

/** Other names under which a unit may be typed behind a number. */
const SPELLED: Readonly<Record<string, string>> = { '°': 'deg', grado: 'deg', grados: 'deg' }

/** How many of a named unit one of the SI unit is worth, as in `deg/s` for `rad/s`; undefined: it is no such unit. */
export function factorNamed(name: string, unit: string): number | undefined {
  for (const units of Object.values(UNITS)) {
    const filed = Object.keys(units)[0] ?? ''
    const rate = unit.slice(filed.length)
    if (!unit.startsWith(filed) || !RATES.includes(rate)) continue
    const base = name.endsWith(rate) ? name.slice(0, name.length - rate.length) : name
    const factor = units[SPELLED[base.toLowerCase()] ?? base]
    if (factor !== undefined) return factor
  }
  return undefined
}
