// Of the last seconds before a stop: which variables, and which element of each, say most.
import type { CourseView } from '../api.gen'
import { numbers, type Stretch } from '../values/series'

export interface StopVariable {
  variable: string
  unit: string
  /** The element that says most. */
  element: number
  width: number
  /** Times are counted from the stop. */
  stretch: Stretch
  /** Whether anything happens in it. */
  moves: boolean
}

/** The variables, as they matter; those in which nothing happens come last. */
export function stopVariables(courses: readonly CourseView[], stop_s: number): StopVariable[] {
  const all = courses.flatMap((course) => variableOf(course, stop_s) ?? [])
  return [...all.filter((course) => course.moves), ...all.filter((course) => !course.moves)]
}

function variableOf(course: CourseView, stop_s: number): StopVariable | undefined {
  const rows = course.values.map((value) => numbers(value))
  const width = rows[0]?.length ?? 0
  if (!width || !rows.every((row) => row?.length === width)) return undefined
  const y = Array.from({ length: width }, (_, k) => Float64Array.from(rows, (row) => row![k]!))
  const scores = y.map(score)
  const element = scores.indexOf(Math.max(...scores))
  return {
    variable: course.variable,
    unit: unitOf(course.unit, element, width),
    element,
    width,
    stretch: { t: Float64Array.from(course.at_s, (at_s) => at_s - stop_s), y },
    moves: scores[element]! > 0,
  }
}

/** Of a list of units, one for each element, that of this one; a dash is none. */
function unitOf(units: string, element: number, width: number): string {
  const all = units.split(',')
  const unit = all.length === width ? all[element]!.trim() : units
  return unit === '-' ? '' : unit
}

/** How much an element says: how far it went; what is no number any more says most of all. */
function score(values: Float64Array): number {
  let [low, high] = [Infinity, -Infinity]
  for (const value of values) {
    if (!Number.isFinite(value)) return Infinity
    low = Math.min(low, value)
    high = Math.max(high, value)
  }
  return values.length ? high - low : 0
}
