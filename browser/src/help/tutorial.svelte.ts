// How far this user is in the tutorial; it goes on where it was left, also another day.
import { desk } from '../link/desk.svelte'
import { look } from '../state/look.svelte'
import { workspace } from '../state/workspace.svelte'
import { keep, kept } from '../state/kept'
import { goTo } from '../act/documents.svelte'
import { COURSE_IDS, COURSES, isOfPuzzles, type CourseId } from './courses'
import { skippedWith, type Lesson, type LessonId, type Seen } from './tutorial'

/** Of each course is kept how far one is; of the first under the bare names. */
const nameIn = (name: string, course: CourseId): string => (course === 'first' ? name : `${name}.${course}`)
const left = COURSE_IDS.find((course) => course === kept<string>('tutorialCourse', 'first')) ?? 'first'

/** What was skipped counts as passed, but gets no tick. */
export const tutorial: { isOpen: boolean; course: CourseId; done: number; skipped: readonly LessonId[] } = $state({
  isOpen: kept('tutorialOpen', false),
  course: left,
  done: kept(nameIn('tutorial', left), 0),
  skipped: kept<LessonId[]>(nameIn('tutorialSkipped', left), []),
})

const kindOf = (name: string): string => nameIn(name, tutorial.course)
export const lessons = (): readonly Lesson[] => COURSES[tutorial.course]

/** Go on in another course where it was left. */
export function choose(course: CourseId): void {
  tutorial.course = course
  keep('tutorialCourse', course)
  tutorial.done = kept(kindOf('tutorial'), 0)
  tutorial.skipped = kept<LessonId[]>(kindOf('tutorialSkipped'), [])
}

/** Open it at the upper level; from the beginning where it was done to its end. */
export function startTutorial(): void {
  if (isOfPuzzles(tutorial.course)) choose('first')
  if (tutorial.done >= lessons().length) beginAgain()
  setOpen(true)
  goTo('applications')
}

/** Open the puzzles. */
export function startPuzzles(): void {
  choose('puzzles')
  setOpen(true)
  goTo('applications')
}

export function setOpen(isOpen: boolean): void {
  if (isOpen) look.folded.right = false // it stands there
  tutorial.isOpen = isOpen
  keep('tutorialOpen', isOpen)
}

/** So many lessons are done. */
export function setDone(done: number): void {
  tutorial.done = Math.max(0, Math.min(done, lessons().length))
  keep(kindOf('tutorial'), tutorial.done)
}

/** From the beginning: nothing is done, and nothing skipped. */
export function beginAgain(): void {
  setDone(0)
  setSkipped([])
}

export function skip(): void {
  const left = skippedWith(tutorial.done, lessons())
  setSkipped([...tutorial.skipped, ...left])
  setDone(tutorial.done + left.length)
}

function setSkipped(skipped: readonly LessonId[]): void {
  tutorial.skipped = skipped
  keep(kindOf('tutorialSkipped'), skipped)
}

export const seen = (): Seen => ({
  isUpper: look.level === 'applications',
  app: workspace.app,
  view: desk.tree.applications[workspace.app],
  run: desk.live.run,
  types: desk.tree.types,
  onikons: desk.tree.onikons,
  dictionaries: desk.tree.dictionaries,
})
