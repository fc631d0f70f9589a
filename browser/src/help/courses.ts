// Courses of lessons: the tutorial, then loops, branches and flows that wait for each other. What ticks is what was done.
import type { StepView } from '../api.gen'
import { isCompleted, isJob, LESSONS, topFlowsOf, type Lesson, type Seen } from './tutorial'

export type CourseId = 'first' | 'loops' | 'branches' | 'meetings'

const all = ({ view }: Seen): StepView[] => Object.values(view?.steps ?? {})
const jobs = (seen: Seen): number => all(seen).filter(isJob).length

/** The branches, each with the steps of its flows. */
function branches({ view }: Seen): { step: StepView; flows: number[][] }[] {
  return all({ view } as Seen)
    .filter((step) => step.kind === 'branch')
    .map((step) => ({ step, flows: (step.flows ?? []).map((path) => [...(view?.flows?.[path]?.steps ?? [])]) }))
}

/** A branch that can choose: a condition, and an action in each of at least two flows. */
const choosing = (seen: Seen): { flows: number[][] }[] =>
  branches(seen).filter(
    ({ step, flows }) =>
      flows.length > 1 &&
      (step.conditions ?? []).some(Boolean) &&
      flows.every((flow) => flow.some((number) => isJob(seen.view?.steps?.[number] ?? {}))),
  )

const wasDone = ({ run }: Seen, flow: readonly number[]): boolean =>
  flow.some((number) => (run?.steps?.[number]?.times ?? 0) > 0)

/** Tags that stand in two flows or more. */
function sharedTags(seen: Seen): string[] {
  const tags = topFlowsOf(seen).map(
    (flow) => new Set(flow.flatMap((number) => seen.view?.steps?.[number]?.synch_tag || [])),
  )
  return [...new Set(tags.flatMap((some) => [...some]))].filter(
    (tag) => tags.filter((some) => some.has(tag)).length > 1,
  )
}

export const COURSES: Readonly<Record<CourseId, readonly Lesson[]>> = {
  first: LESSONS,
  loops: [
    { id: 'twoActions', isDone: (seen) => seen.isUpper && jobs(seen) > 1 && !seen.view?.holes },
    { id: 'loop', isDone: (seen) => all(seen).some((step) => step.loop) },
    {
      id: 'loopRun',
      isDone: (seen) =>
        all(seen).some((step) => step.loop) &&
        isCompleted(seen) &&
        Object.values(seen.run?.steps ?? {}).some((step) => (step.times ?? 0) > 1),
    },
  ],
  branches: [
    { id: 'branch', isDone: (seen) => seen.isUpper && branches(seen).length > 0 },
    { id: 'branchFlows', isDone: (seen) => choosing(seen).length > 0 },
    {
      id: 'branchRun',
      isDone: (seen) =>
        isCompleted(seen) &&
        choosing(seen).some(({ flows }) => flows.filter((flow) => wasDone(seen, flow)).length === 1),
    },
  ],
  meetings: [
    { id: 'twoFlows', isDone: (seen) => seen.view?.is_parallel === true && topFlowsOf(seen).length > 1 },
    { id: 'tags', isDone: (seen) => sharedTags(seen).length > 0 },
    {
      id: 'meet',
      isDone: (seen) => isCompleted(seen) && (seen.run?.meets ?? []).some(({ tag }) => sharedTags(seen).includes(tag)),
    },
  ],
}

export const COURSE_IDS = Object.keys(COURSES) as CourseId[]
