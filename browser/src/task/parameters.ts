// The parameters of a task: what its module declares of each, as rows with sliders, and the LOCAL lines that a change makes.
import type { AskItem, ParameterView, TaskView } from '../api.gen'
import { fields, type Field } from '../question/question'

export type Lines = [string, string[]][]

/** The rows of a parameter, one for each element: bounded ones may have a slider. None where its module is not read. */
export function rowsOf(parameter: ParameterView): Field[] {
  const type = /^\w+/.exec(parameter.shape ?? '')?.[0]
  if (!type) return []
  const isVector = parameter.shape!.includes('[')
  const count = isVector ? (parameter.words ?? []).length : 1
  const bound = (limit: number | null | undefined, none: number): number[] =>
    Array.from({ length: count }, () => limit ?? none)
  const item: AskItem = {
    name: parameter.name,
    type,
    count,
    unit: parameter.unit ?? '',
    meaning: parameter.meaning ?? '',
    low: bound(parameter.low, -Infinity),
    high: bound(parameter.high, Infinity),
  }
  return fields({ items: [item] })
}

/** The LOCAL lines of a task with other words for one parameter. Without words it is as its module has it, if it may be. */
export function linesWith(task: TaskView, parameter: ParameterView, words: readonly string[]): Lines {
  const lines = (task.local ?? []).map(([key, parts]): [string, string[]] => [key, [...parts]])
  const at = lines.findIndex(([key]) => key === parameter.name)
  if (!words.length && parameter.default?.length) return lines.filter((_, k) => k !== at)
  if (at < 0) return [...lines, [parameter.name, [...words]]]
  lines[at] = [parameter.name, [...words]]
  return lines
}

/** Whether it is as its module has it where no line says otherwise. */
export const isDefault = (parameter: ParameterView): boolean =>
  !parameter.default?.length || parameter.default.join(' ') === (parameter.words ?? []).join(' ')

/** A word that is only read, not filed: a number that another unit made long has six digits. */
export function readWord(word: string): string {
  return word.length > 8 && Number.isFinite(Number(word)) ? String(Number(Number(word).toPrecision(6))) : word
}
