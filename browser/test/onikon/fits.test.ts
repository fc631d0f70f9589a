// Where the next icon goes and what has the edge for it: Equation 7 as the page shows it.
import { describe, expect, test } from 'vitest'
import type { ApplicationView, StepView } from '../../src/api.gen'
import { fits, gapAt, isOfAnotherArm, jobBefore } from '../../src/onikon/fits'

const step = (left: string, right: string, more: Partial<StepView> = {}): StepView => ({ left, right, ...more })

/** open, turn to, a hole for its target, close. */
const app: ApplicationView = {
  name: 'pick',
  order: 0,
  flows: { '0': { steps: [1, 2, 3, 4], start: '1', end: '1' }, '1/9/0': { steps: [], start: '1', end: '1' } },
  steps: {
    1: step('1', '1'),
    2: step('1', '2'),
    3: step('2', '1', { kind: 'hole', wants: ['Joint object'] }),
    4: step('1', '1'),
  },
}

describe('the place where the next icon goes (D03)', () => {
  test('behind the start icon wants its edge, and what the first step has', () => {
    expect(gapAt(app, { flow: '0', after: 0 })).toEqual({ left: '1', right: '1', wants: [], isHole: false })
  })

  test('before a hole is the hole', () => {
    // R-D19
    expect(gapAt(app, { flow: '0', after: 2 })).toEqual({
      left: '2',
      right: '1',
      wants: ['Joint object'],
      isHole: true,
    })
  })

  test('pointing at a hole means the same place', () =>
    expect(gapAt(app, { flow: '0', after: 3 })).toEqual(gapAt(app, { flow: '0', after: 2 })))

  test('behind the last step is before the end icon', () => {
    expect(gapAt(app, { flow: '0', after: 4 })).toEqual({ left: '1', right: '1', wants: [], isHole: false })
  })

  test('in an empty flow of a branch is between its start and its end', () => {
    expect(gapAt(app, { flow: '1/9/0', after: 0 })?.left).toBe('1')
  })

  test('that is gone is none', () => {
    expect(gapAt(app, { flow: '0', after: 77 })).toBeUndefined()
    expect(gapAt(app, { flow: '5', after: 0 })).toBeUndefined()
    expect(gapAt(undefined, { flow: '0', after: 0 })).toBeUndefined()
  })
})

test('edges decide what fits, not names (D22)', () => {
  const hole = gapAt(app, { flow: '0', after: 2 })
  expect(fits({ left: '2' }, hole)).toBe(true)
  expect(fits({ left: '1' }, hole)).toBe(false)
  expect(fits({ left: '2' }, undefined)).toBe(false)
})

describe('the job to which a target would belong', () => {
  const line: ApplicationView = {
    ...app,
    steps: { ...app.steps, 1: step('1', '2', { name: 'jmoveC', role: 'job' }), 2: step('2', '2', { role: 'target' }) },
  }

  test('R-D08: stands before the place, across targets and holes', () => {
    expect(jobBefore(line, { flow: '0', after: 2 })?.name).toBe('jmoveC')
    expect(jobBefore(line, { flow: '0', after: 3 })?.name).toBe('jmoveC')
  })

  test('R-D08: is none at the start, or where no such place is', () => {
    expect(jobBefore(line, { flow: '0', after: 0 })).toBeUndefined()
    expect(jobBefore(line, { flow: '7', after: 2 })).toBeUndefined()
    expect(jobBefore(undefined, { flow: '0', after: 2 })).toBeUndefined()
  })

  test('R-D08: moves another arm only where both arms are known', () => {
    expect(isOfAnotherArm({ arm: 'puma' }, ['puma_right'])).toBe(true)
    expect(isOfAnotherArm({ arm: 'puma' }, ['puma', 'led_monitor'])).toBe(false)
    expect(isOfAnotherArm({ arm: 'puma' }, [])).toBe(false)
    expect(isOfAnotherArm({}, ['puma'])).toBe(false)
  })
})
