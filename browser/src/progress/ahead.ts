// What is still to come in a flow, as far as it can be read from the order of its icons.
import type { ApplicationView, AppFlowView, FlowRunView, StepView } from '../api.gen'

export interface Ahead {
  /** The action after which the flow will pause. */
  step: number
  /** How many actions away it is; 0: the one that is carried out now. */
  actions: number
  /** The condition under which it pauses; empty: always. */
  condition: string
}

/** The next breakpoint from a step on, that one too unless it is done; from 0: from the beginning. Branches are passed by. */
export function nextBreakpoint(
  flow: AppFlowView | undefined,
  steps: Readonly<Record<string, StepView>>,
  from: number,
  isDone = false,
): Ahead | undefined {
  const numbers = flow?.steps ?? []
  const start = numbers.indexOf(from)
  let actions = start < 0 ? 0 : -1
  for (const number of numbers.slice(Math.max(0, start))) {
    const step = steps[number]
    if (!step || !isAction(step)) continue
    actions += 1
    if (step.breaks && !(isDone && number === from)) return { step: number, actions, condition: step.break_if ?? '' }
  }
  return undefined
}

/** Whether it is carried out: neither a target nor a hole nor a branch. */
export const isAction = (step: StepView): boolean =>
  (step.kind ?? 'icon') === 'icon' && step.role !== 'target' && step.is_joined !== true

/** The steps of an action: its own and those of its targets behind it. */
export function stepsOfAction(
  flow: AppFlowView | undefined,
  steps: Readonly<Record<string, StepView>>,
  step: number,
): number[] {
  const numbers = flow?.steps ?? []
  const at = numbers.indexOf(step)
  if (at < 0) return []
  let end = at + 1
  while (end < numbers.length && steps[numbers[end]!]?.is_joined) end += 1
  return numbers.slice(at, end)
}

/** Where a flow is in its application: the step it carries out, or the one before which it waits at a tag. */
export function placeOf(app: ApplicationView | undefined, flow: FlowRunView, state: string): number {
  const step = flow.step ?? 0
  if (state !== 'waiting' || !flow.tag || !app) return step
  const numbers =
    Object.values(app.flows ?? {}).find((flow) => flow.steps?.includes(step))?.steps ??
    app.flows?.[String(flow.order)]?.steps ??
    []
  const later = [...numbers.slice(numbers.indexOf(step) + 1), ...numbers]
  return later.find((number) => app.steps?.[number]?.synch_tag === flow.tag) ?? step
}
