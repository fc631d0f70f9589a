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

/** A program that is shipped and works: it counts when that one, as it is, was run to its end. */
const example = (id: LessonId, name: string, more: (seen: Seen) => boolean = () => true): Lesson => ({
  id,
  example: name,
  isDone: (seen) => seen.view?.name === name && !seen.view.is_dirty && isCompleted(seen) && more(seen),
})

/** Something that is done with a program of one's own: none that is shipped counts. */
const own = (id: LessonId, isDone: (seen: Seen) => boolean): Lesson => ({
  id,
  isDone: (seen) => isMine(seen) && isDone(seen),
})

/** The program that is broken to see what becomes of it. */
const GRASP = 'try_to_grasp'

export const COURSES: Readonly<Record<CourseId, readonly Lesson[]>> = {
  first: LESSONS.map((lesson) => ({ ...lesson, isDone: (seen) => isMine(seen) && lesson.isDone(seen) })),
  loops: [
    example('loopSee', 'wave_three', (seen) => cameRound(seen, 3)),
    own('twoActions', (seen) => jobs(seen) > 1 && !seen.view?.holes),
    own('loop', (seen) => all(seen).some((step) => step.loop)),
    own('loopRun', (seen) => isCompleted(seen) && cameRound(seen, 2)),
    own(
      'loopWithin',
      (seen) => isCompleted(seen) && innerLoops(seen).some((loop) => loop.some((number) => timesOf(seen, number) > 3)),
    ),
  ],
  branches: [
    example('branchSee', 'see_the_lamp', (seen) => branches(seen).some(({ flows }) => wayTaken(seen, flows) >= 0)),
    own('branch', (seen) => branches(seen).length > 0),
    own('branchFlows', (seen) => choosing(seen).length > 0),
    own('branchRun', (seen) => isCompleted(seen) && choosing(seen).some((flows) => wayTaken(seen, flows) >= 0)),
    own(
      'branchMiddle',
      (seen) =>
        isCompleted(seen) &&
        choosing(seen).some((flows) => wayTaken(seen, flows) > 0 && wayTaken(seen, flows) < flows.length - 1),
    ),
  ],
  meetings: [
    example('meetSee', 'both_wave', (seen) => met(seen).length > 0),
    own('twoFlows', (seen) => seen.view?.is_parallel === true && topFlowsOf(seen).length > 1),
    own('tags', (seen) => sharedTags(seen).length > 0),
    own('meet', (seen) => isCompleted(seen) && met(seen).length > 0),
    own('meetTwice', (seen) => isCompleted(seen) && met(seen).length > 1),
  ],
  arms: [
    example('armsSee', 'two_arms', haveMoved),
    own('armsFlows', (seen) => twoArms(seen) !== undefined && !seen.view?.holes),
    own('armsRun', (seen) => isCompleted(seen) && haveMoved(seen)),
    own('armsWait', (seen) => isCompleted(seen) && haveMoved(seen) && hasWaited(seen)),
  ],
  nesting: [
    example('nestSee', 'visit_boxes', (seen) => nested(seen).some((number) => timesOf(seen, number) > 0)),
    { id: 'nestInside', isDone: (seen) => seen.isUpper && seen.view?.name === 'visit' },
    own('nestUse', (seen) => nested(seen).length > 0 && !seen.view?.holes),
    own('nestRun', (seen) => isCompleted(seen) && nested(seen).some((number) => timesOf(seen, number) > 0)),
    own('nestOwn', (seen) => isCompleted(seen) && nested(seen).some((n) => isOwn(seen, n) && timesOf(seen, n) > 0)),
  ],
  seeking: [
    example('seekSee', GRASP),
    { id: 'seekRefused', isDone: (seen) => isGrasp(seen) && !!seen.view?.holes },
    { id: 'seekMended', goesWith: 'seekRefused', isDone: (seen) => isGrasp(seen) && !seen.view?.holes },
    { id: 'seekStops', isDone: (seen) => isGrasp(seen) && !!seen.view?.is_dirty && hasStopped(seen) },
    { id: 'seekOwn', isDone: (seen) => isGrasp(seen) && !!seen.view?.is_dirty && isCompleted(seen) },
  ],
  faults: [],
  puzzles: [],
}

export const COURSE_IDS = Object.keys(COURSES) as CourseId[]

/** Whether it is a program that somebody here has made. */
const isMine = ({ isUpper, view, dictionaries }: Seen): boolean =>
  isUpper && view !== undefined && dictionaries[view.base ?? '']?.is_shipped !== true

const isGrasp = (seen: Seen): boolean => seen.isUpper && seen.view?.name === GRASP

/** Whether a flow of the run of this program has stood still because something was wrong. */
const hasStopped = (seen: Seen): boolean => isOfThis(seen) && Object.keys(seen.run?.stops ?? {}).length > 0

/** Whether two arms, each in a flow of its own, have done something. */
function haveMoved(seen: Seen): boolean {
  return twoArms(seen)?.every((flow) => wasDone(seen, flow)) === true
}
