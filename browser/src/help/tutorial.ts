// The tutorial: a few deeds, each seen to be done by what is there afterwards.
import type { ApplicationView, DictionaryView, OnikonView, RunView, StepView, TypeView } from '../api.gen'

type OfCourses =
  | 'loopSee'
  | 'twoActions'
  | 'loop'
  | 'loopRun'
  | 'loopWithin'
  | 'branchSee'
  | 'branch'
  | 'branchFlows'
  | 'branchRun'
  | 'branchMiddle'
  | 'meetSee'
  | 'twoFlows'
  | 'tags'
  | 'meet'
  | 'meetTwice'
  | 'armsSee'
  | 'armsFlows'
  | 'armsRun'
  | 'armsWait'
  | 'nestSee'
  | 'nestInside'
  | 'nestUse'
  | 'nestRun'
  | 'nestOwn'
  | 'seekSee'
  | 'seekRefused'
  | 'seekMended'
  | 'seekStops'
  | 'seekOwn'
export type LessonId =
  'new' | 'complete' | 'job' | 'fill' | 'out' | 'back' | 'run' | 'pause' | 'goOn' | 'end' | 'save' | OfCourses

/** What is seen while it goes on. */
export interface Seen {
  isUpper: boolean
  /** Id of the application shown, and what is in it. */
  app: string
  view: ApplicationView | undefined
  run: RunView | null
  types: Readonly<Record<string, TypeView>>
  /** Icons by name, dictionaries by path. */
  onikons: Readonly<Record<string, OnikonView>>
  dictionaries: Readonly<Record<string, DictionaryView>>
}

export interface Lesson {
  id: LessonId
  /** The lesson before, of which it makes sense only if that was done. */
  goesWith?: LessonId
  /** The program that is shipped and is looked at, by name. */
  example?: string
  isDone: (seen: Seen) => boolean
}

/** The icons of the shipped laboratory that the lessons name. */
const NAMED = { complete: 'opengripC', job: 'jmoveC' }
/** What takes an icon out of a program, as the environment calls it. */
const TAKING_OUT = ['desk.deleting', 'desk.cutting']

const kindOf = (step: StepView): string => step.kind ?? 'icon'
export const isJob = (step: StepView): boolean => kindOf(step) === 'icon' && step.role === 'job'

/** The steps of each flow that is within no branch. */
export const topFlowsOf = ({ view }: Seen): (readonly number[])[] =>
  Object.entries(view?.flows ?? {}).flatMap(([path, { steps = [] }]) => (path.includes('/') ? [] : [steps]))

/** The steps of the first flow, in order. */
function steps({ view }: Seen): StepView[] {
  return (view?.flows?.['0']?.steps ?? []).flatMap((number) => view?.steps?.[number] ?? [])
}

const takes = (step: StepView, { types }: Seen): boolean =>
  kindOf(step) === 'icon' && step.role === 'job' && !!types[step.type ?? '']?.takes
const isTarget = (step: StepView): boolean => kindOf(step) === 'icon' && step.role === 'target'

/** Whether a job that takes a target stands there, under this name if one is given, with the target or with the hole for it. */
function hasAction(seen: Seen, with_: (step: StepView) => boolean, name = ''): boolean {
  const all = steps(seen)
  const isMeant = (step: StepView): boolean => takes(step, seen) && (!name || step.name === name)
  return all.some((step, k) => isMeant(step) && all[k + 1] !== undefined && with_(all[k + 1]!))
}

const flowsOf = ({ run }: Seen): string[] =>
  Object.values(run?.flows ?? {}).flatMap((flow) => [flow.state ?? 'ready', ...(flow.is_pausing ? ['pausing'] : [])])
export const isMine = ({ run, app }: Seen): boolean => run !== null && run.doc === app
const isRunning = (seen: Seen): boolean => isMine(seen) && (seen.run?.state ?? 'beginning') === 'running'
const isPaused = (seen: Seen): boolean =>
  isRunning(seen) && flowsOf(seen).some((state) => state === 'paused' || state === 'pausing')
const isOver = (seen: Seen): boolean => isMine(seen) && seen.run?.state === 'over'
export const isCompleted = (seen: Seen): boolean => isOver(seen) && seen.run?.is_completed === true

/** Whether what was done last took something out; whether what was taken back last did. */
const wasTakenOut = ({ view }: Seen): boolean => TAKING_OUT.includes(view?.undo?.key ?? '')
const wasTakenBack = ({ view }: Seen): boolean => TAKING_OUT.includes(view?.redo?.key ?? '')

export const LESSONS: readonly Lesson[] = [
  { id: 'new', isDone: (seen) => seen.isUpper && seen.view !== undefined && !seen.view.path },
  { id: 'complete', isDone: (seen) => steps(seen).some((step) => step.name === NAMED.complete) },
  { id: 'job', isDone: (seen) => hasAction(seen, () => true, NAMED.job) },
  { id: 'fill', isDone: (seen) => hasAction(seen, isTarget) },
  { id: 'out', isDone: (seen) => wasTakenOut(seen) && hasAction(seen, (step) => kindOf(step) === 'hole') },
  { id: 'back', goesWith: 'out', isDone: (seen) => wasTakenBack(seen) && hasAction(seen, isTarget) },
  { id: 'run', isDone: (seen) => isRunning(seen) || isOver(seen) },
  { id: 'pause', isDone: isPaused },
  { id: 'goOn', goesWith: 'pause', isDone: (seen) => (isRunning(seen) && !isPaused(seen)) || isCompleted(seen) },
  { id: 'end', isDone: isCompleted },
  { id: 'save', isDone: (seen) => !!seen.view?.path && !seen.view.is_dirty },
]

/** How many lessons are done now, where so many were done before: one after the other, and what was done stays done. */
export function advanced(done: number, seen: Seen, lessons: readonly Lesson[] = LESSONS): number {
  let at = done
  while (at < lessons.length && lessons[at]!.isDone(seen)) at += 1
  return at
}

/** Which lessons are left out where the one at this place is skipped: it, and what only goes on from it. */
export function skippedWith(at: number, lessons: readonly Lesson[] = LESSONS): LessonId[] {
  const [lesson, next] = [lessons[at], lessons[at + 1]]
  if (!lesson) return []
  return next?.goesWith === lesson.id ? [lesson.id, next.id] : [lesson.id]
}
