// Lessons of loops, branches, flows that meet, two arms and nesting: nothing ticks that was not really done. R-H07
import { readdirSync, readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import type { ApplicationView, RunView } from '../../src/api.gen'
import { COURSE_IDS, COURSES, isOfPuzzles, type CourseId } from '../../src/help/courses'
import { advanced, type LessonId, type Seen } from '../../src/help/tutorial'
import { en } from '../../src/texts/en'
import { LOOKS, looped } from './lessonLooks'
import { MOVE, named, OPEN, over, seen, view } from './seenProgram'

/** Whether this lesson, and none but it, is told by what is seen. */
const isDone = (id: LessonId, view: ApplicationView, run: RunView | null = null): boolean =>
  Object.values(COURSES)
    .flat()
    .find((lesson) => lesson.id === id)!
    .isDone(seen(view, run))
const WITH_LESSONS = COURSE_IDS.filter((course) => course !== 'first' && !isOfPuzzles(course))
const LESSON_IDS = WITH_LESSONS.flatMap((course) => COURSES[course].map(({ id }) => id))

test.each(LESSON_IDS)('%s counts when it was done, and not when something like it was', (id) => {
  const { is, isNot } = LOOKS[id]!
  expect(isDone(id, ...is)).toBe(true)
  expect(isNot.map((look) => isDone(id, ...look))).toEqual(isNot.map(() => false))
})

const OF_ONES_OWN = LESSON_IDS.filter((id) => !LOOKS[id]!.is[0].base)

test.each(OF_ONES_OWN)('%s is not done by a program that is shipped, but by one that was saved', (id) => {
  const [program, run] = LOOKS[id]!.is
  expect(isDone(id, { ...program, name: 'both_wave', path: '/shipped/both_wave.appl', base: '/shipped' }, run)).toBe(
    false,
  )
  expect(isDone(id, { ...program, path: '/own/mine.appl', base: '/own' }, run)).toBe(true)
})

test('no lesson of the tutorial is done by a program that is shipped', () => {
  const shipped = { ...view({ 0: [OPEN, MOVE] }), path: '/shipped/assemble.appl', base: '/shipped' }
  for (const { id, isDone } of COURSES.first) expect(isDone(seen(shipped, over())), id).toBe(false)
  expect(
    COURSES.first.find(({ id }) => id === 'complete')!.isDone(seen({ ...shipped, path: '', base: '' }, null)),
  ).toBe(true)
})

test.each(WITH_LESSONS)('the program with which %s begins is not seen to work where it was changed', (course) => {
  const { id } = COURSES[course][0]!
  const [program, run] = LOOKS[id]!.is
  expect(isDone(id, { ...program, is_dirty: true }, run)).toBe(false)
})

test.each(LESSON_IDS)('%s is not done where nothing is open', (id) => {
  const nothing: Seen = { ...seen(view({}), null), view: undefined }
  const lesson = Object.values(COURSES)
    .flat()
    .find((one) => one.id === id)!
  expect(lesson.isDone(nothing)).toBe(false)
})

test('a course goes on lesson by lesson, and what comes later ticks nothing before it', () => {
  const done = (view: ApplicationView, run: RunView | null, from = 0): number =>
    advanced(from, seen(view, run), COURSES.loops)
  expect(done(view(looped), over({ 2: 9 }))).toBe(0)
  expect(done(named('wave_three', looped), over({ 2: 3 }))).toBe(1)
  expect(done(view(looped), over({ 2: 2 }), 1)).toBe(4)
})

test('each course begins with a program to look at, and ends with something to find out', () => {
  for (const course of WITH_LESSONS) {
    expect(COURSES[course][0]!.example, course).toBeTruthy()
    expect(en[`tutorial.${COURSES[course].at(-1)!.id}`], course).toMatch(/^Find out: /)
  }
})

test('the guide has the same courses with the same steps under the same names', () => {
  const guide = readFileSync(new URL('../../../docs/guide/40-courses.md', import.meta.url), 'utf8')
  const courses = guide.split(/^## /m).slice(1)
  const headings = courses.map((course) => ({
    title: course.split('\n')[0],
    steps: [...course.matchAll(/^### (\d+)\. (.+)$/gm)].map(([, number, title]) => [Number(number), title]),
  }))
  const steps = (course: CourseId): string[] =>
    isOfPuzzles(course) ? puzzleTitles(course === 'faults') : COURSES[course].map(({ id }) => en[`tutorial.${id}`])
  const expected = COURSE_IDS.filter((course) => course !== 'first').map((course: CourseId) => ({
    title: en[`tutorial.course.${course}`],
    steps: steps(course).map((title, k) => [k + 1, title]),
  }))
  expect(headings.filter(({ steps }) => steps.length)).toEqual(expected)
})

/** The English titles of the shipped puzzles, easiest first. */
function puzzleTitles(isFault: boolean): string[] {
  const labs = new URL('../../../src/onika/labs/', import.meta.url)
  const files = readdirSync(labs, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.puzzle'))
  const line = (text: string, words: string): string =>
    text
      .split('\n')
      .find((row) => row.replace(/ +/g, ' ').startsWith(words))
      ?.replace(/ +/g, ' ')
      .slice(words.length)
      .trim() ?? ''
  return files
    .map((file) => ({
      name: file.split('/').at(-1)!.replace('.puzzle', ''),
      text: readFileSync(new URL(file, labs), 'utf8'),
    }))
    .filter(({ text }) => (line(text, 'PROGRAM') !== '') === isFault)
    .sort((a, b) => Number(line(a.text, 'LEVEL')) - Number(line(b.text, 'LEVEL')) || (a.name < b.name ? -1 : 1))
    .map(({ text }) => line(text, 'TITLE en'))
}
