// What came of variables at every cycle, bounded in time; the runtime numbers the values, so that what is lost shows.
import type { SampledView } from '../api.gen'
import type { Reason } from '../texts/say'
import type { Stretch } from '../values/series'
import { held, type Course } from './response'

/** So long is kept. */
export const KEPT_S = 30

interface Kept {
  last: number
  missed: number
  labels: readonly string[]
  t: number[]
  rows: (readonly number[])[]
  reason: Reason | null
}

/** A column of the table: an element of a variable. */
export interface Column {
  variable: string
  element: number
  label: string
}

export class Samples {
  private readonly kept = new Map<string, Kept>()

  /** What to ask for: the number of the last value of each. */
  after(variables: readonly string[]): number[] {
    return variables.map((variable) => this.kept.get(variable)?.last ?? 0)
  }

  take(views: readonly SampledView[]): void {
    for (const view of views) {
      const kept = this.kept.get(view.variable) ?? { last: 0, missed: 0, labels: [], t: [], rows: [], reason: null }
      kept.last = view.last
      kept.missed += view.missed ?? 0
      kept.reason = view.reason ?? null
      if (view.labels?.length) kept.labels = view.labels
      for (const at_s of view.at_s ?? []) kept.t.push(at_s)
      for (const row of view.rows ?? []) kept.rows.push(row)
      const old = kept.t.findIndex((at_s) => at_s >= (kept.t.at(-1) ?? 0) - KEPT_S)
      if (old > 0) {
        kept.t.splice(0, old)
        kept.rows.splice(0, old)
      }
      this.kept.set(view.variable, kept)
    }
  }

  columns(variables: readonly string[]): Column[] {
    return variables.flatMap((variable) =>
      (this.kept.get(variable)?.labels ?? []).map((label, element) => ({ variable, element, label })),
    )
  }

  missed(variables: readonly string[]): number {
    return variables.reduce((sum, variable) => sum + (this.kept.get(variable)?.missed ?? 0), 0)
  }

  /** Why no more comes of them. */
  reason(variables: readonly string[]): Reason | null {
    return (
      variables.map((variable) => this.kept.get(variable)?.reason ?? null).find((reason) => reason !== null) ?? null
    )
  }

  /** When the newest of them was written; NaN: nothing came. */
  last_s(variables: readonly string[]): number {
    const ends = variables.flatMap((variable) => this.kept.get(variable)?.t.at(-1) ?? [])
    return ends.length ? Math.max(...ends) : NaN
  }

  /** The samples of a column within a time. */
  course(column: Column, from_s = -Infinity, to_s = Infinity): Course {
    const { t, rows } = this.kept.get(column.variable) ?? { t: [], rows: [] }
    const places = t.flatMap((at_s, k) => (at_s >= from_s && at_s <= to_s ? [k] : []))
    return { t: places.map((k) => t[k]!), y: places.map((k) => rows[k]![column.element] ?? NaN) }
  }

  /** All columns on one axis: at each time at which any was written, the values in force. */
  stretch(columns: readonly Column[], from_s: number, to_s: number): Stretch {
    const courses = columns.map((column) => this.course(column, from_s, to_s))
    const t = Float64Array.from([...new Set(courses.flatMap((course) => Array.from(course.t)))].sort((a, b) => a - b))
    return { t, y: courses.map((course) => held(course, t)) }
  }

  /** The same as a table for other programs: what was not written at a time is left empty. */
  csv(columns: readonly Column[], from_s: number, to_s: number): string {
    const lines = new Map<number, string[]>()
    columns.forEach((column, place) => {
      const { t, y } = this.course(column, from_s, to_s)
      for (let k = 0; k < t.length; k += 1) {
        const at_us = Math.round((t[k]! - from_s) * 1e6)
        const line = lines.get(at_us) ?? columns.map(() => '')
        line[place] = String(y[k])
        lines.set(at_us, line)
      }
    })
    const head = ['t_s', ...columns.map(({ label }) => (label.includes(',') ? `"${label}"` : label))]
    const rows = [...lines].sort(([a], [b]) => a - b).map(([at_us, line]) => [(at_us / 1e6).toFixed(6), ...line])
    return [head, ...rows].map((line) => `${line.join(',')}\r\n`).join('')
  }
}
