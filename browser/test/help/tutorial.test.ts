// The tutorial sees by itself what is done, in order, and what was done stays done.
import { expect, test } from 'vitest'
import type { ApplicationView, RunView, StepView } from '../../src/api.gen'
import { advanced, LESSONS, skippedWith, type LessonId, type Seen } from '../../src/help/tutorial'

const OPEN: StepView = { role: 'job', type: 'Complete job' }
const MOVE: StepView = { role: 'job', type: 'Joint job' }
const TARGET: StepView = { role: 'target', type: 'Joint object', is_joined: true }
const HOLE: StepView = { kind: 'hole', is_joined: true }
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
const seen = (more: Partial<Seen>): Seen => ({ isUpper: true, app: 'a1', view: undefined, run: null, types, ...more })
const before = (id: LessonId): number => LESSONS.findIndex((one) => one.id === id)

const DEEDS: [LessonId, Partial<Seen>][] = [
  ['new', { view: view([]) }],
  ['complete', { view: view([OPEN]) }],
  ['job', { view: view([OPEN, MOVE, HOLE]) }],
  ['fill', { view: view([OPEN, MOVE, TARGET]) }],
  ['out', { view: view([OPEN, MOVE, HOLE]) }],
  ['back', { view: view([OPEN, MOVE, TARGET]) }],
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
