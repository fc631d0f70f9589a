// Lessons of loops, branches and flows that meet: nothing ticks that was not really done. R-H07
import { expect, test } from 'vitest'
import type { ApplicationView, RunView, StepView } from '../../src/api.gen'
import { COURSES, type CourseId } from '../../src/help/courses'
import { advanced, type Seen } from '../../src/help/tutorial'

const OPEN: StepView = { role: 'job', name: 'opengripC' }
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
const over = (more: Partial<RunView> = {}): RunView => ({
  doc: 'a1',
  name: 'x',
  number: 1,
  state: 'over',
  is_completed: true,
  ...more,
})
const done = (course: CourseId, view: ApplicationView, run: RunView | null = null): number =>
  advanced(0, { isUpper: true, app: 'a1', view, run, types: {} } satisfies Seen, COURSES[course])

test('a loop counts when it was there and something in it was done twice', () => {
  const looped = view({ 0: [{ ...OPEN, loop: 'A' }, OPEN] })
  expect(done('loops', view({ 0: [OPEN] }))).toBe(0)
  expect(done('loops', view({ 0: [OPEN, OPEN] }, { holes: 1 }))).toBe(0)
  expect(done('loops', view({ 0: [OPEN, OPEN] }))).toBe(1)
  expect(done('loops', looped, over({ steps: { 1: { times: 1 } } }))).toBe(2)
  expect(done('loops', looped, over({ steps: { 1: { times: 2 } }, is_completed: false }))).toBe(2)
  expect(done('loops', looped, over({ steps: { 1: { times: 2 } }, doc: 'a2' }))).toBe(2)
  expect(done('loops', looped, over({ steps: { 1: { times: 2 } } }))).toBe(3)
})

test('a branch counts when it chose one of its flows', () => {
  const branch: StepView = { kind: 'branch', conditions: ['LAMP == 1'], flows: ['0/1/0', '0/1/1'] }
  const flows = { 0: [branch], '0/1/0': [OPEN], '0/1/1': [OPEN] }
  expect(done('branches', view({ 0: [OPEN] }))).toBe(0)
  expect(done('branches', view({ ...flows, '0/1/1': [] }))).toBe(1)
  expect(done('branches', view({ ...flows, 0: [{ ...branch, conditions: [''] }] }))).toBe(1)
  expect(done('branches', view(flows), over())).toBe(2)
  expect(done('branches', view(flows), over({ steps: { 2: { times: 1 }, 3: { times: 1 } } }))).toBe(2)
  expect(done('branches', view(flows), over({ steps: { 3: { times: 1 } } }))).toBe(3)
})

test('flows have met when they began together at a tag of both', () => {
  const tagged = { ...OPEN, synch_tag: 'A' }
  const two = view({ 0: [tagged], 1: [tagged] }, { is_parallel: true })
  const meets = [{ tag: 'A', flows: ['flow0', 'flow1'], skew_us: 0, at_s: 1 }]
  expect(done('meetings', view({ 0: [OPEN], 1: [OPEN] }))).toBe(0)
  expect(done('meetings', view({ 0: [tagged, tagged], 1: [OPEN] }, { is_parallel: true }))).toBe(1)
  expect(done('meetings', two, over())).toBe(2)
  expect(done('meetings', two, over({ meets: [{ ...meets[0]!, tag: 'B' }] }))).toBe(2)
  expect(done('meetings', two, over({ meets }))).toBe(3)
})
