// What belongs together in a flow.
import { describe, expect, test } from 'vitest'
import type { ApplicationView, StepView } from '../../src/api.gen'
import { actionsOf, flowOf, headOf, inReadingOrder, loopsOf, topsOf, wholeOf } from '../../src/application/actions'

const job = (more: Partial<StepView> = {}): StepView => ({ name: 'turn', role: 'job', ...more })
const target: StepView = { name: 'above', role: 'target', is_joined: true }
const hole: StepView = { kind: 'hole', is_joined: true, wants: ['Joint object'] }

function app(steps: Record<number, StepView>, flows: Record<string, number[]>): ApplicationView {
  return {
    name: 'a',
    order: 0,
    steps,
    flows: Object.fromEntries(Object.entries(flows).map(([path, numbers]) => [path, { steps: numbers }])),
  }
}

describe('an action', () => {
  const one = app(
    { 1: job(), 2: target, 3: job(), 4: hole, 5: { ...target, is_joined: false }, 6: job() },
    { 0: [1, 2, 3, 4, 5, 6] },
  )
  const actions = actionsOf(one)

  test('is a job with its targets, or the holes for them', () => {
    expect(wholeOf(actions, 2)).toEqual([1, 2])
    expect(wholeOf(actions, 3)).toEqual([3, 4])
    expect(headOf(actions, 4)).toBe(3)
  })

  test('is counted once; a target without a job is none', () => {
    // R-D06
    expect(actions.counts.get('0')).toBe(3)
    expect(actions.of.get(6)?.index).toBe(3)
    expect(wholeOf(actions, 5)).toEqual([5])
  })
})

describe('loops', () => {
  test('go from the test to the anchor, whichever comes first', () => {
    // R-D06
    const bottom = app({ 1: job({ loop: 'a' }), 2: job({ loop: 'a', is_test: true, loop_if: 'X > 1' }) }, { 0: [1, 2] })
    const top = app({ 1: job({ loop: 'a', is_test: true }), 2: job({ loop: 'a' }) }, { 0: [1, 2] })
    expect(loopsOf(bottom)).toEqual([{ tag: 'a', flow: '0', test: 2, anchor: 1, condition: 'X > 1', depth: 0 }])
    expect(loopsOf(top)[0]).toMatchObject({ test: 1, anchor: 2 })
  })

  test('lie below those within them', () => {
    const nested = app(
      {
        1: job({ loop: 'o' }),
        2: job({ loop: 'i' }),
        3: job({ loop: 'i', is_test: true }),
        4: job({ loop: 'o', is_test: true }),
      },
      { 0: [1, 2, 3, 4] },
    )
    expect(Object.fromEntries(loopsOf(nested).map((loop) => [loop.tag, loop.depth]))).toEqual({ o: 1, i: 0 })
  })

  test('need both ends in one flow', () => {
    expect(loopsOf(app({ 1: job({ loop: 'a' }), 2: job({ loop: 'a', is_test: true }) }, { 0: [1], 1: [2] }))).toEqual(
      [],
    )
  })
})

test('flows of branches are no flows of the application itself', () => {
  // R-D13
  const one = app(
    { 1: job(), 7: { kind: 'branch', flows: ['0/7/0'] }, 8: job() },
    { 0: [7], 10: [1], 2: [], '0/7/0': [8] },
  )
  expect(topsOf(one)).toEqual(['0', '2', '10'])
  expect(flowOf(one, 8)).toBe('0/7/0')
})

test('what is picked is taken in the order in which it stands', () => {
  // R-D05
  const one = app({ 1: job(), 2: job(), 3: job() }, { 0: [3, 1, 2] })
  expect(inReadingOrder(one, new Set([1, 2, 3]))).toEqual([3, 1, 2])
})
