// The tutorial sees by itself what is done, in order, and what was done stays done.
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import type { ApplicationView, RunView, StepView } from '../../src/api.gen'
import { en } from '../../src/texts/en'
import { advanced, LESSONS, skippedWith, type LessonId, type Seen } from '../../src/help/tutorial'

const OPEN: StepView = { role: 'job', name: 'opengripC', type: 'Complete job' }
const MOVE: StepView = { role: 'job', name: 'jmoveC', type: 'Joint job' }
const TARGET: StepView = { role: 'target', type: 'Joint object', is_joined: true }
const HOLE: StepView = { kind: 'hole', is_joined: true }
const DELETING = { key: 'desk.deleting', text: 'deleting an icon' }
const types = {
  'Complete job': { order: 0, role: 'job' as const, left: '0', right: '0' },
  'Joint job': { order: 1, role: 'job' as const, left: '0', right: '1', takes: 'Joint object' },
}

const view = (steps: StepView[], more: Partial<ApplicationView> = {}): ApplicationView => ({
  name: 'Untitled-1',
  order: 0,
  flows: { 0: { steps: steps.map((_, k) => k + 1) } },
  steps: Object.fromEntries(steps.map((step, k) => [k + 1, step])),
  ...more,
})
const run = (state: RunView['state'], flow: object = {}, more: Partial<RunView> = {}): RunView => ({
  doc: 'a1',
  name: 'Untitled-1',
  number: 1,
  state,
  flows: { flow0: { order: 0, ...flow } },
  ...more,
})
const seen = (more: Partial<Seen>): Seen => ({
  isUpper: true,
  app: 'a1',
  view: undefined,
  run: null,
  types,
  onikons: {},
  dictionaries: {},
  ...more,
})
const before = (id: LessonId): number => LESSONS.findIndex((one) => one.id === id)

const DEEDS: [LessonId, Partial<Seen>][] = [
  ['new', { view: view([]) }],
  ['complete', { view: view([OPEN]) }],
  ['job', { view: view([OPEN, MOVE, HOLE]) }],
  ['fill', { view: view([OPEN, MOVE, TARGET]) }],
  ['out', { view: view([OPEN, MOVE, HOLE], { undo: DELETING }) }],
  ['back', { view: view([OPEN, MOVE, TARGET], { redo: DELETING }) }],
  ['run', { view: view([OPEN, MOVE, TARGET]), run: run('running', { state: 'running' }) }],
  ['pause', { view: view([OPEN, MOVE, TARGET]), run: run('running', { state: 'running', is_pausing: true }) }],
  ['goOn', { view: view([OPEN, MOVE, TARGET]), run: run('running', { state: 'running' }) }],
  ['end', { view: view([OPEN, MOVE, TARGET]), run: run('over', { state: 'ended' }, { is_completed: true }) }],
  ['save', { view: view([OPEN, MOVE, TARGET], { path: '/x.appl' }), run: run('over', {}, { is_completed: true }) }],
]

test('each deed is one lesson further, and none is done before its deed', () => {
  let done = advanced(0, seen({ isUpper: false }))
  expect(done).toBe(0)
  for (const [id, what] of DEEDS) {
    expect(LESSONS[done]!.id).toBe(id)
    done = advanced(done, seen(what))
  }
  expect(done).toBe(LESSONS.length)
})

test('what was done stays done when it is no longer to be seen', () =>
  expect(advanced(before('run'), seen({}))).toBe(before('run')))

test('a run of another application does not count', () => {
  const other = run('running', { state: 'running' }, { doc: 'a2' })
  expect(advanced(before('run'), seen({ view: view([OPEN]), run: other }))).toBe(before('run'))
})

test('a run that was over before it was paused leaves the lesson to be done', () => {
  const over = run('over', { state: 'ended' }, { is_completed: true })
  expect(advanced(before('run'), seen({ run: over }))).toBe(before('pause'))
})

test('who skips a deed skips also the one that only goes on from it', () => {
  expect(skippedWith(before('out'))).toEqual(['out', 'back'])
  expect(skippedWith(before('pause'))).toEqual(['pause', 'goOn'])
  expect(skippedWith(before('run'))).toEqual(['run'])
  expect(skippedWith(LESSONS.length)).toEqual([])
})

test('a hole of another job is no target that was taken out, and one that is filled anew is nothing taken back', () => {
  const second = view([OPEN, MOVE, TARGET, MOVE, HOLE])
  expect(advanced(before('out'), seen({ view: second }))).toBe(before('out'))
  expect(advanced(before('back'), seen({ view: view([OPEN, MOVE, TARGET], { undo: DELETING }) }))).toBe(before('back'))
})

test('another icon than the one that a lesson names gets no tick', () => {
  const close: StepView = { ...OPEN, name: 'closegripC' }
  expect(advanced(before('complete'), seen({ view: view([close]) }))).toBe(before('complete'))
  const line: StepView = { ...MOVE, name: 'cmoveC' }
  expect(advanced(before('job'), seen({ view: view([OPEN, line, HOLE]) }))).toBe(before('job'))
})

test('a run that was ended while it was paused did not go on', () => {
  const aborted = run('over', { state: 'ended' }, { is_completed: false })
  expect(advanced(before('goOn'), seen({ run: aborted }))).toBe(before('goOn'))
})

test('the guide has the same steps under the same names', () => {
  const guide = readFileSync(new URL('../../../docs/guide/16-fifteen-minutes.md', import.meta.url), 'utf8')
  const headings = [...guide.matchAll(/^### (\d+)\. (.+)$/gm)].map(([, number, title]) => [Number(number), title])
  expect(headings).toEqual(LESSONS.map(({ id }, k) => [k + 1, en[`tutorial.${id}`]]))
})
