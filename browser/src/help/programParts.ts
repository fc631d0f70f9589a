// What a program consists of that lessons speak of: loops, branches, tags, arms, programs within it; and what a run did.
import type { StepView } from '../api.gen'
import { isJob, topFlowsOf, type Seen } from './tutorial'

export const all = ({ view }: Seen): StepView[] => Object.values(view?.steps ?? {})
export const jobs = (seen: Seen): number => all(seen).filter(isJob).length

/** How often a step was carried out in the run. */
export const timesOf = ({ run }: Seen, number: number): number => run?.steps?.[number]?.times ?? 0
export const wasDone = (seen: Seen, flow: readonly number[]): boolean =>
  flow.some((number) => timesOf(seen, number) > 0)

/** The steps of every flow, those within branches too. */
const everyFlow = ({ view }: Seen): (readonly number[])[] =>
  Object.values(view?.flows ?? {}).map(({ steps = [] }) => steps)

/** The steps from one end of each loop to the other. */
function loops(seen: Seen): (readonly number[])[] {
  return everyFlow(seen).flatMap((flow) => {
    const tags = new Set(flow.flatMap((number) => seen.view?.steps?.[number]?.loop || []))
    return [...tags].map((tag) => {
      const ends = flow.flatMap((number, k) => (seen.view?.steps?.[number]?.loop === tag ? [k] : []))
      return flow.slice(ends[0], ends.at(-1)! + 1)
    })
  })
}

/** Whether something in a loop was carried out so often. */
export const cameRound = (seen: Seen, often: number): boolean =>
  loops(seen).some((steps) => steps.some((number) => timesOf(seen, number) >= often))

/** The loops that lie wholly within another one. */
export const innerLoops = (seen: Seen): (readonly number[])[] =>
  loops(seen).filter((inner, _k, every) =>
    every.some((outer) => outer.length > inner.length && inner.every((number) => outer.includes(number))),
  )

/** The branches, each with the steps of its flows. */
export function branches({ view }: Seen): { step: StepView; flows: number[][] }[] {
  return all({ view } as Seen)
    .filter((step) => step.kind === 'branch')
    .map((step) => ({ step, flows: (step.flows ?? []).map((path) => [...(view?.flows?.[path]?.steps ?? [])]) }))
}

/** Whether it is something that is done: a job, a whole program, or nothing for once. */
const isAction = (step: StepView): boolean => isJob(step) || step.role === 'application' || step.role === 'nop'

/** The flows of the branches that can choose: by a condition, with an action in each of at least two flows. */
export const choosing = (seen: Seen): number[][][] =>
  branches(seen)
    .filter(
      ({ step, flows }) =>
        flows.length > 1 &&
        (step.conditions ?? []).some(Boolean) &&
        flows.every((flow) => flow.some((number) => isAction(seen.view?.steps?.[number] ?? {}))),
    )
    .map(({ flows }) => flows)

/** The only flow of a branch that was carried out, by its place; -1: none, or several. */
export function wayTaken(seen: Seen, flows: readonly (readonly number[])[]): number {
  const taken = flows.flatMap((flow, k) => (wasDone(seen, flow) ? [k] : []))
  return taken.length === 1 ? taken[0]! : -1
}

/** Tags that stand in two flows or more. */
export function sharedTags(seen: Seen): string[] {
  const tags = topFlowsOf(seen).map(
    (flow) => new Set(flow.flatMap((number) => seen.view?.steps?.[number]?.synch_tag || [])),
  )
  return [...new Set(tags.flatMap((some) => [...some]))].filter(
    (tag) => tags.filter((some) => some.has(tag)).length > 1,
  )
}

/** The tags at which flows have begun together. */
export const met = (seen: Seen): string[] =>
  sharedTags(seen).filter((tag) => (seen.run?.meets ?? []).some((meet) => meet.tag === tag))

/** The arms that a flow moves: the tasks with a device of its jobs that take a target. */
function arms(seen: Seen, flow: readonly number[]): string[] {
  return flow.flatMap((number) => {
    const onikon = seen.onikons[seen.view?.steps?.[number]?.name ?? '']
    return onikon?.role === 'job' && onikon.takes?.length ? (onikon.hardware ?? []) : []
  })
}

/** Two flows side by side that move arms, none of them the same; undefined: there are none. */
export function twoArms(seen: Seen): [readonly number[], readonly number[]] | undefined {
  if (!seen.view?.is_parallel) return undefined
  const moving = topFlowsOf(seen).filter((flow) => arms(seen, flow).length)
  for (const one of moving)
    for (const other of moving)
      if (one !== other && !arms(seen, one).some((arm) => arms(seen, other).includes(arm))) return [one, other]
  return undefined
}

/** Whether flows have begun together at a tag that stands first in one of them and later in another: that one is waited for. */
export function hasWaited(seen: Seen): boolean {
  const placesOf = (tag: string): number[] =>
    topFlowsOf(seen).flatMap((flow) => {
      const jobs = flow.filter((number) => isJob(seen.view?.steps?.[number] ?? {}))
      const place = jobs.findIndex((number) => seen.view?.steps?.[number]?.synch_tag === tag)
      return place < 0 ? [] : [place]
    })
  return met(seen).some((tag) => Math.min(...placesOf(tag)) === 0 && Math.max(...placesOf(tag)) > 0)
}

/** The steps that stand for whole programs, by number. */
export const nested = (seen: Seen): number[] =>
  Object.entries(seen.view?.steps ?? {}).flatMap(([number, step]) =>
    step.role === 'application' ? [Number(number)] : [],
  )

/** Whether the program behind a step was made a picture by the user. */
export function isOwn(seen: Seen, number: number): boolean {
  const onikon = seen.onikons[seen.view?.steps?.[number]?.name ?? '']
  return onikon !== undefined && seen.dictionaries[onikon.dictionary]?.is_shipped !== true
}
