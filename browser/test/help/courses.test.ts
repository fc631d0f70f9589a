// Lessons of loops, branches, flows that meet, two arms and nesting: nothing ticks that was not really done. R-H07
import { readdirSync, readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import type { ApplicationView, DictionaryView, OnikonView, RunView, StepView } from '../../src/api.gen'
import { COURSE_IDS, COURSES, isOfPuzzles, type CourseId } from '../../src/help/courses'
import { advanced, type LessonId, type Seen } from '../../src/help/tutorial'
import { en } from '../../src/texts/en'

const OPEN: StepView = { role: 'job', name: 'opengripC' }
const MOVE: StepView = { role: 'job', name: 'jmoveC' }
const MOVE_RIGHT: StepView = { role: 'job', name: 'jmove_rightC' }
const VISIT: StepView = { role: 'application', name: 'visit' }
const onikon = (more: Partial<OnikonView>): OnikonView => ({
  type: '',
  role: 'job',
  order: 0,
  dictionary: '/shipped',
  left: '0',
  right: '0',
  picture: '',
  ...more,
})
const onikons = {
  opengripC: onikon({ hardware: ['gripper'] }),
  jmoveC: onikon({ hardware: ['puma'], takes: ['Joint object'] }),
  jmove_rightC: onikon({ hardware: ['puma_right'], takes: ['Joint object'] }),
  visit: onikon({ role: 'application' }),
  mine: onikon({ role: 'application', dictionary: '/own' }),
}
const dictionaries: Record<string, DictionaryView> = {
  '/shipped': { name: 'boxes', path: '/shipped', order: 0, onikons: 4, is_shipped: true },
  '/own': { name: 'own', path: '/own', order: 1, onikons: 1 },
}

const view = (flows: Record<string, StepView[]>, more: Partial<ApplicationView> = {}): ApplicationView => {
  const steps: Record<string, StepView> = {}
  const numbered = Object.entries(flows).map(([path, all]) => {
    const numbers = all.map((step) => {
      const number = Object.keys(steps).length + 1
      steps[number] = step
      return number
    })
    return [path, { steps: numbers }] as const
  })
  return { name: 'x', order: 0, flows: Object.fromEntries(numbered), steps, ...more }
}
/** A run that came to its end, in which the steps were done so often. */
const over = (times: Record<number, number> = {}, more: Partial<RunView> = {}): RunView => ({
  doc: 'a1',
  name: 'x',
  number: 1,
  state: 'over',
  is_completed: true,
  steps: Object.fromEntries(Object.entries(times).map(([number, times]) => [number, { times }])),
  ...more,
})
const meeting = (...tags: string[]): Partial<RunView> => ({
  meets: tags.map((tag) => ({ tag, flows: ['flow0', 'flow1'], skew_us: 0, at_s: 1 })),
})
const seen = (view: ApplicationView, run: RunView | null): Seen => ({
  isUpper: true,
  app: 'a1',
  view,
  run,
  types: {},
  onikons,
  dictionaries,
})
/** Whether this lesson, and none but it, is told by what is seen. */
const isDone = (id: LessonId, view: ApplicationView, run: RunView | null = null): boolean =>
  Object.values(COURSES)
    .flat()
    .find((lesson) => lesson.id === id)!
    .isDone(seen(view, run))
const named = (name: string, flows: Record<string, StepView[]>, more: Partial<ApplicationView> = {}): ApplicationView =>
  view(flows, { name, base: '/shipped', ...more })
const incomplete = { is_completed: false }
const stopped: Partial<RunView> = {
  is_completed: false,
  stops: { flow0: { text: { key: 'x' } as never, kind: 'error', at_s: 1 } },
}
const ofAnother = { doc: 'a2' }

/** Per course: a lesson, what it needs to be seen, and what looks like it and is not. */
type Look = [ApplicationView, RunView | null]
const looped = { 0: [{ ...OPEN, loop: 'A' }, OPEN, { ...OPEN, loop: 'A' }] }
const within = {
  0: [
    { ...OPEN, loop: 'A' },
    { ...OPEN, loop: 'B' },
    { ...OPEN, loop: 'B' },
    { ...OPEN, loop: 'A' },
  ],
}
const branch: StepView = { kind: 'branch', conditions: ['LAMP == 1'], flows: ['0/1/0', '0/1/1'] }
const branched = { 0: [branch], '0/1/0': [OPEN], '0/1/1': [OPEN] }
const three = {
  0: [{ ...branch, conditions: ['LAMP == 1', 'LAMP == 0'], flows: ['0/1/0', '0/1/1', '0/1/2'] }],
  '0/1/0': [OPEN],
  '0/1/1': [OPEN],
  '0/1/2': [OPEN],
}
const A = { ...MOVE, synch_tag: 'A' }
const B = { ...MOVE, synch_tag: 'B' }
const RIGHT_A = { ...MOVE_RIGHT, synch_tag: 'A' }
const parallel = { is_parallel: true }
const LOOKS: Partial<Record<LessonId, { is: Look; isNot: Look[] }>> = {
  loopSee: {
    is: [named('wave_three', looped), over({ 2: 3 })],
    isNot: [
      [view(looped), over({ 2: 3 })],
      [named('wave_three', looped), over({ 2: 3 }, incomplete)],
      [named('wave_three', looped), null],
    ],
  },
  twoActions: {
    is: [view({ 0: [OPEN, OPEN] }), null],
    isNot: [
      [view({ 0: [OPEN] }), null],
      [view({ 0: [OPEN, MOVE] }, { holes: 1 }), null],
      [named('wave_three', looped), null],
    ],
  },
  loop: {
    is: [view(looped), null],
    isNot: [
      [view({ 0: [OPEN, OPEN] }), null],
      [named('wave_three', looped), null],
    ],
  },
  loopRun: {
    is: [view(looped), over({ 2: 2 })],
    isNot: [
      [view(looped), over({ 2: 1 })],
      [view(looped), over({ 2: 2 }, incomplete)],
      [view(looped), over({ 2: 2 }, ofAnother)],
      [view({ 0: [...looped[0], OPEN] }), over({ 2: 1, 4: 2 })],
    ],
  },
  loopWithin: {
    is: [view(within), over({ 2: 4, 3: 4 })],
    isNot: [
      [view(within), over({ 1: 4, 2: 2 })],
      [view(looped), over({ 2: 4 })],
      [view(within), over({ 2: 4 }, incomplete)],
      [view({ 0: [...looped[0], { ...OPEN, loop: 'B' }, { ...OPEN, loop: 'B' }] }), over({ 2: 4, 4: 4, 5: 4 })],
    ],
  },
  branchSee: {
    is: [named('see_the_lamp', branched), over({ 2: 1 })],
    isNot: [
      [view(branched), over({ 2: 1 })],
      [named('see_the_lamp', branched), over()],
    ],
  },
  branch: {
    is: [view(branched), null],
    isNot: [
      [view({ 0: [OPEN] }), null],
      [named('see_the_lamp', branched), null],
    ],
  },
  branchFlows: {
    is: [view(branched), null],
    isNot: [
      [view({ ...branched, '0/1/1': [] }), null],
      [view({ ...branched, 0: [{ ...branch, conditions: [''] }] }), null],
    ],
  },
  branchRun: {
    is: [view(branched), over({ 3: 1 })],
    isNot: [
      [view(branched), over()],
      [view(branched), over({ 2: 1, 3: 1 })],
      [view(branched), over({ 3: 1 }, ofAnother)],
    ],
  },
  branchMiddle: {
    is: [view(three), over({ 3: 1 })],
    isNot: [
      [view(three), over({ 2: 1 })],
      [view(three), over({ 4: 1 })],
      [view(branched), over({ 3: 1 })],
      [view(three), over({ 3: 1 }, incomplete)],
    ],
  },
  meetSee: {
    is: [named('both_wave', { 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('A'))],
    isNot: [
      [view({ 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('A'))],
      [named('both_wave', { 0: [A], 1: [RIGHT_A] }, parallel), over()],
    ],
  },
  twoFlows: {
    is: [view({ 0: [OPEN], 1: [OPEN] }, parallel), null],
    isNot: [
      [view({ 0: [OPEN], 1: [OPEN] }), null],
      [view({ 0: [OPEN] }, parallel), null],
    ],
  },
  tags: {
    is: [view({ 0: [A], 1: [RIGHT_A] }, parallel), null],
    isNot: [
      [view({ 0: [A, A], 1: [MOVE_RIGHT] }, parallel), null],
      [named('both_wave', { 0: [A], 1: [RIGHT_A] }, parallel), null],
    ],
  },
  meet: {
    is: [view({ 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('A'))],
    isNot: [
      [view({ 0: [A], 1: [RIGHT_A] }, parallel), over()],
      [view({ 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('B'))],
    ],
  },
  meetTwice: {
    is: [view({ 0: [A, B], 1: [A, B] }, parallel), over({}, meeting('A', 'B'))],
    isNot: [
      [view({ 0: [A, B], 1: [A, B] }, parallel), over({}, meeting('A', 'A'))],
      [view({ 0: [A, B], 1: [A, B] }, parallel), over({}, { ...meeting('A', 'B'), ...incomplete })],
    ],
  },
  armsSee: {
    is: [named('two_arms', { 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 })],
    isNot: [
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 })],
      [named('two_arms', { 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1 })],
    ],
  },
  armsFlows: {
    is: [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), null],
    isNot: [
      [view({ 0: [MOVE], 1: [MOVE] }, parallel), null],
      [view({ 0: [MOVE], 1: [OPEN] }, parallel), null],
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }), null],
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, { ...parallel, holes: 1 }), null],
      [named('two_arms', { 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), null],
    ],
  },
  armsRun: {
    is: [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 })],
    isNot: [
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 2: 1 })],
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 }, incomplete)],
    ],
  },
  armsWait: {
    is: [view({ 0: [MOVE, A], 1: [RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 }, meeting('A'))],
    isNot: [
      [view({ 0: [A, MOVE], 1: [RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 }, meeting('A'))],
      [view({ 0: [MOVE, A], 1: [MOVE_RIGHT, RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 }, meeting('A'))],
      [view({ 0: [MOVE, A], 1: [RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 })],
    ],
  },
  seekSee: {
    is: [named('try_to_grasp', { 0: [MOVE] }), over()],
    isNot: [
      [view({ 0: [MOVE] }), over()],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over()],
      [named('try_to_grasp', { 0: [MOVE] }), over({}, incomplete)],
    ],
  },
  seekRefused: {
    is: [named('try_to_grasp', { 0: [MOVE] }, { holes: 1 }), null],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }), null],
      [view({ 0: [MOVE] }, { holes: 1 }), null],
    ],
  },
  seekMended: {
    is: [named('try_to_grasp', { 0: [MOVE] }), null],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }, { holes: 1 }), null],
      [view({ 0: [MOVE] }), null],
    ],
  },
  seekStops: {
    is: [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over({}, { ...stopped, state: 'running' })],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }), over({}, stopped)],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over()],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over({}, { ...stopped, ...ofAnother })],
      [view({ 0: [MOVE] }, { is_dirty: true }), over({}, stopped)],
    ],
  },
  seekOwn: {
    is: [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over()],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }), over()],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over({}, incomplete)],
      [view({ 0: [MOVE] }, { is_dirty: true }), over()],
    ],
  },
  nestSee: {
    is: [named('visit_boxes', { 0: [VISIT, MOVE] }), over({ 1: 1 })],
    isNot: [
      [view({ 0: [VISIT, MOVE] }), over({ 1: 1 })],
      [named('visit_boxes', { 0: [VISIT, MOVE] }), over({ 2: 1 })],
    ],
  },
  nestInside: { is: [named('visit', { 0: [MOVE] }), null], isNot: [[named('visit_boxes', { 0: [VISIT] }), null]] },
  nestUse: {
    is: [view({ 0: [VISIT] }), null],
    isNot: [
      [view({ 0: [VISIT] }, { holes: 1 }), null],
      [view({ 0: [MOVE] }), null],
      [named('visit_boxes', { 0: [VISIT] }), null],
    ],
  },
  nestRun: {
    is: [view({ 0: [VISIT] }), over({ 1: 1 })],
    isNot: [
      [view({ 0: [VISIT] }), over({ 1: 1 }, incomplete)],
      [view({ 0: [MOVE] }), over({ 1: 1 })],
      [named('visit_boxes', { 0: [VISIT] }), over({ 1: 1 })],
    ],
  },
  nestOwn: {
    is: [view({ 0: [{ ...VISIT, name: 'mine' }] }), over({ 1: 1 })],
    isNot: [
      [view({ 0: [VISIT] }), over({ 1: 1 })],
      [view({ 0: [{ ...VISIT, name: 'gone' }] }), over({ 1: 1 })],
      [view({ 0: [{ ...VISIT, name: 'mine' }] }), null],
    ],
  },
}
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
