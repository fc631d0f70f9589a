// Courses of lessons: the tutorial, then one for each thing that programs can do. Each begins with one that works, and ends
// with something to find out. What ticks is what was done.
import {
  all,
  branches,
  cameRound,
  choosing,
  hasWaited,
  innerLoops,
  isOwn,
  jobs,
  met,
  nested,
  sharedTags,
  timesOf,
  twoArms,
  wasDone,
  wayTaken,
} from './programParts'
import { isCompleted, isMine as isOfThis, LESSONS, topFlowsOf, type Lesson, type LessonId, type Seen } from './tutorial'

export type CourseId =
  'first' | 'loops' | 'branches' | 'meetings' | 'arms' | 'nesting' | 'seeking' | 'faults' | 'puzzles'

/** What has no lessons of its own, but puzzles, which the environment judges. */
export const isOfPuzzles = (course: CourseId): boolean => course === 'faults' || course === 'puzzles'

/** A program that is shipped and works: it counts when that one was run to its end. */
const example = (id: LessonId, name: string, more: (seen: Seen) => boolean): Lesson => ({
  id,
  example: name,
  isDone: (seen) => seen.view?.name === name && isCompleted(seen) && more(seen),
})

/** The program that is broken to see what becomes of it. */
const GRASP = 'try_to_grasp'

export const COURSES: Readonly<Record<CourseId, readonly Lesson[]>> = {
  first: LESSONS,
  loops: [
    example('loopSee', 'wave_three', (seen) => cameRound(seen, 3)),
    { id: 'twoActions', isDone: (seen) => isMine(seen, 'wave_three') && jobs(seen) > 1 && !seen.view?.holes },
    { id: 'loop', isDone: (seen) => isMine(seen, 'wave_three') && all(seen).some((step) => step.loop) },
    { id: 'loopRun', isDone: (seen) => isCompleted(seen) && cameRound(seen, 2) },
    {
      id: 'loopWithin',
      isDone: (seen) =>
        isCompleted(seen) && innerLoops(seen).some((loop) => loop.some((number) => timesOf(seen, number) > 3)),
    },
  ],
  branches: [
    example('branchSee', 'see_the_lamp', (seen) => branches(seen).some(({ flows }) => wayTaken(seen, flows) >= 0)),
    { id: 'branch', isDone: (seen) => isMine(seen, 'see_the_lamp') && branches(seen).length > 0 },
    { id: 'branchFlows', isDone: (seen) => choosing(seen).length > 0 },
    {
      id: 'branchRun',
      isDone: (seen) => isCompleted(seen) && choosing(seen).some((flows) => wayTaken(seen, flows) >= 0),
    },
    {
      id: 'branchMiddle',
      isDone: (seen) =>
        isCompleted(seen) &&
        choosing(seen).some((flows) => wayTaken(seen, flows) > 0 && wayTaken(seen, flows) < flows.length - 1),
    },
  ],
  meetings: [
    example('meetSee', 'both_wave', (seen) => met(seen).length > 0),
    {
      id: 'twoFlows',
      isDone: (seen) => isMine(seen, 'both_wave') && seen.view?.is_parallel === true && topFlowsOf(seen).length > 1,
    },
    { id: 'tags', isDone: (seen) => isMine(seen, 'both_wave') && sharedTags(seen).length > 0 },
    { id: 'meet', isDone: (seen) => isCompleted(seen) && met(seen).length > 0 },
    { id: 'meetTwice', isDone: (seen) => isCompleted(seen) && met(seen).length > 1 },
  ],
  arms: [
    example('armsSee', 'two_arms', (seen) => haveMoved(seen)),
    { id: 'armsFlows', isDone: (seen) => isMine(seen, 'two_arms') && twoArms(seen) !== undefined && !seen.view?.holes },
    { id: 'armsRun', isDone: (seen) => isMine(seen, 'two_arms') && isCompleted(seen) && haveMoved(seen) },
    { id: 'armsWait', isDone: (seen) => isCompleted(seen) && haveMoved(seen) && hasWaited(seen) },
  ],
  nesting: [
    example('nestSee', 'visit_boxes', (seen) => nested(seen).some((number) => timesOf(seen, number) > 0)),
    { id: 'nestInside', isDone: (seen) => seen.isUpper && seen.view?.name === 'visit' },
    { id: 'nestUse', isDone: (seen) => isMine(seen, 'visit_boxes') && nested(seen).length > 0 && !seen.view?.holes },
    {
      id: 'nestRun',
      isDone: (seen) =>
        isMine(seen, 'visit_boxes') && isCompleted(seen) && nested(seen).some((number) => timesOf(seen, number) > 0),
    },
    {
      id: 'nestOwn',
      isDone: (seen) =>
        isCompleted(seen) && nested(seen).some((number) => isOwn(seen, number) && timesOf(seen, number) > 0),
    },
  ],
  seeking: [
    example('seekSee', GRASP, (seen) => !seen.view?.is_dirty),
    { id: 'seekRefused', isDone: (seen) => isGrasp(seen) && !!seen.view?.holes },
    { id: 'seekMended', goesWith: 'seekRefused', isDone: (seen) => isGrasp(seen) && !seen.view?.holes },
    { id: 'seekStops', isDone: (seen) => isGrasp(seen) && !!seen.view?.is_dirty && hasStopped(seen) },
    { id: 'seekOwn', isDone: (seen) => isGrasp(seen) && !!seen.view?.is_dirty && isCompleted(seen) },
  ],
  faults: [],
  puzzles: [],
}

export const COURSE_IDS = Object.keys(COURSES) as CourseId[]

/** Whether it is another program than the one that was to be looked at. */
function isMine(seen: Seen, shipped: string): boolean {
  return seen.isUpper && seen.view !== undefined && seen.view.name !== shipped
}

const isGrasp = (seen: Seen): boolean => seen.isUpper && seen.view?.name === GRASP

/** Whether a flow of the run of this program has stood still because something was wrong. */
const hasStopped = (seen: Seen): boolean => isOfThis(seen) && Object.keys(seen.run?.stops ?? {}).length > 0

/** Whether two arms, each in a flow of its own, have done something. */
const haveMoved = (seen: Seen): boolean => twoArms(seen)?.every((flow) => wasDone(seen, flow)) === true
