// Parameter sets beside the parameters as they are now: one row for each parameter, one column for each set.
import type { ParameterSetsView } from '../api.gen'

export interface SetRow {
  task: string
  key: string
  /** As it is now; undefined: no task here has it. */
  present: string | undefined
  /** In each set; undefined: the set does not hold it. */
  values: (string | undefined)[]
  differs: boolean
}

type Value = readonly [string, string, readonly string[]]

export function setRows(view: ParameterSetsView): SetRow[] {
  const sets = (view.sets ?? []).map((set) => byName(set.values ?? []))
  const now = byName(view.present ?? [])
  const names = new Set([now, ...sets].flatMap((values) => [...values.keys()]))
  return [...names].map((name) => {
    const [task, key] = JSON.parse(name) as [string, string]
    const present = now.get(name)
    const values = sets.map((set) => set.get(name))
    return { task, key, present, values, differs: values.some((value) => value !== undefined && value !== present) }
  })
}

/** Whether switching to a set would change nothing. */
export const isNow = (rows: readonly SetRow[], set: number): boolean =>
  rows.every((row) => row.values[set] === undefined || row.present === undefined || row.values[set] === row.present)

const byName = (values: readonly Value[]): Map<string, string> =>
  new Map(values.map(([task, key, words]) => [JSON.stringify([task, key]), words.join(' ')]))
