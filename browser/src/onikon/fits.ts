// Where the next icon goes, and which icons have the edge for it (Equation 7). The environment judges; this only shows.
import type { ApplicationView, OnikonView, StepView } from '../api.gen'
import type { Place } from '../state/workspace.svelte'

/** A place between two steps: the edges that what comes there should have, by their keys. */
export interface Gap {
  /** The left edge that it must have. */
  readonly left: string
  /** The right edge with which nothing stays open behind it. */
  readonly right: string
  /** The types of the targets that are missing there. */
  readonly wants: readonly string[]
  readonly isHole: boolean
}

/** The gap at a place of an application; undefined where there is no such place. */
export function gapAt(app: ApplicationView | undefined, { flow, after }: Place): Gap | undefined {
  const line = app?.flows?.[flow]
  if (!app || !line) return undefined
  const numbers = line.steps ?? []
  const at = after === 0 ? -1 : numbers.indexOf(after)
  if (after !== 0 && at < 0) return undefined
  const before = app.steps?.[after]
  // Pointing at a hole means the place that it keeps open.
  const hole = before?.kind === 'hole' ? before : app.steps?.[numbers[at + 1] ?? -1]
  if (hole?.kind === 'hole')
    return { left: hole.left ?? '', right: hole.right ?? '', wants: hole.wants ?? [], isHole: true }
  const left = after === 0 ? line.start : before?.right
  return { left: left ?? '', right: hole?.left ?? line.end ?? '', wants: [], isHole: false }
}

/** The place that a step has: what comes there in its stead has its left edge, and best its right one too. */
export const placeOf = ({ left = '', right = '' }: { left?: string; right?: string }): Gap => ({
  left,
  right,
  wants: [],
  isHole: true,
})

/** The step of the job to which a target behind a step would belong; undefined: there is none. */
export function jobBefore(app: ApplicationView | undefined, { flow, after }: Place): StepView | undefined {
  const steps = app?.flows?.[flow]?.steps ?? []
  for (let at = steps.indexOf(after); at >= 0; at--) {
    const step = app?.steps?.[steps[at]!]
    if (step?.kind !== 'hole' && step?.role !== 'target') return step
  }
  return undefined
}

/** Whether a target was made for another arm than those that a job moves; `hardware` are the job's tasks with a device. */
export const isOfAnotherArm = ({ arm }: Pick<OnikonView, 'arm'>, hardware: readonly string[]): boolean =>
  !!arm && hardware.length > 0 && !hardware.includes(arm)

type Edges = Pick<OnikonView, 'left'>

export const fits = (edges: Edges, gap: Gap | undefined): boolean => gap !== undefined && edges.left === gap.left
