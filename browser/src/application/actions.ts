/** What belongs together in a flow: actions with their targets, and loops; as far as drawing needs it. */

import type { ApplicationView, StepView } from '../api.gen'

/** A job or application and its targets, or the holes for them, in order. */
export interface Action {
  readonly flow: string
  readonly steps: readonly number[]
  /** Which one in its flow, from 1. */
  readonly index: number
}

export interface Actions {
  /** By each of its steps. */
  readonly of: ReadonlyMap<number, Action>
  /** How many each flow has. */
  readonly counts: ReadonlyMap<string, number>
}

/** A tag at two actions of one flow. */
export interface Loop {
  readonly tag: string
  readonly flow: string
  readonly test: number
  readonly anchor: number
  readonly condition: string
  /** How many loops lie within it: its line runs below theirs. */
  readonly depth: number
}

/** Whether a step that is not joined begins an action. */
const isHead = (step: StepView | undefined): boolean =>
  step !== undefined && (step.kind ?? 'icon') === 'icon' && step.role !== 'target'

/** The paths of the application's own flows, in order. */
export const topsOf = (app: ApplicationView): string[] =>
  Object.keys(app.flows ?? {})
    .filter((path) => !path.includes('/'))
    .sort((a, b) => Number(a) - Number(b))

/** Whether nothing stands in it. */
export const isBlank = (app: ApplicationView): boolean =>
  Object.values(app.flows ?? {}).every(({ steps }) => !steps?.length)

export function actionsOf(app: ApplicationView): Actions {
  const of = new Map<number, Action>()
  const counts = new Map<string, number>()
  for (const [flow, { steps = [] }] of Object.entries(app.flows ?? {})) {
    let [index, open]: [number, number[]] = [0, []]
    for (const number of steps) {
      const step = app.steps?.[number]
      // What is joined is asked first: there are thousands of steps, and each question is followed up for changes.
      if (step?.is_joined) {
        const action = of.get(open[0] ?? -1)
        if (!action) continue
        open.push(number)
        of.set(number, action)
      } else if (isHead(step)) {
        open = [number]
        of.set(number, { flow, steps: open, index: ++index })
      } else open = []
    }
    counts.set(flow, index)
  }
  return { of, counts }
}

export function loopsOf(app: ApplicationView): Loop[] {
  const loops: (Loop & { from: number; to: number })[] = []
  for (const [flow, { steps = [] }] of Object.entries(app.flows ?? {})) {
    const ends = new Map<string, number[]>()
    steps.forEach((number, at) => {
      const tag = app.steps?.[number]?.loop
      if (tag) ends.get(tag)?.push(at) ?? ends.set(tag, [at])
    })
    for (const [tag, [a, b]] of ends) {
      if (a === undefined || b === undefined) continue
      const isFirst = app.steps?.[steps[a]!]?.is_test === true
      const [test, anchor] = isFirst ? [steps[a]!, steps[b]!] : [steps[b]!, steps[a]!]
      loops.push({ tag, flow, test, anchor, condition: app.steps?.[test]?.loop_if ?? '', depth: 0, from: a, to: b })
    }
  }
  const deep = (loop: (typeof loops)[number]): number =>
    Math.max(
      0,
      ...loops
        .filter((other) => other !== loop && other.flow === loop.flow && other.from >= loop.from && other.to <= loop.to)
        .map((other) => 1 + deep(other)),
    )
  return loops.map((loop) => ({
    tag: loop.tag,
    flow: loop.flow,
    test: loop.test,
    anchor: loop.anchor,
    condition: loop.condition,
    depth: deep(loop),
  }))
}

/** The step and all that stays with it: marks belong to the whole action. */
export const wholeOf = (actions: Actions, number: number): readonly number[] =>
  actions.of.get(number)?.steps ?? [number]

/** The step that has the marks of an action: its job. */
export const headOf = (actions: Actions, number: number): number => actions.of.get(number)?.steps[0] ?? number

/** The flow a step stands in. */
export function flowOf(app: ApplicationView | undefined, number: number): string {
  for (const [path, { steps = [] }] of Object.entries(app?.flows ?? {})) if (steps.includes(number)) return path
  return ''
}

/** Steps in the order in which they stand. */
export function inReadingOrder(app: ApplicationView | undefined, steps: Iterable<number>): number[] {
  const wanted = new Set(steps)
  const paths = Object.keys(app?.flows ?? {})
  return paths.flatMap((path) => (app?.flows?.[path]?.steps ?? []).filter((number) => wanted.has(number)))
}
