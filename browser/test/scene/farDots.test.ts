// Dots from afar are one outline for each look.
import { expect, test } from 'vitest'
import { dotOutlines, farDot, lookOf } from '../../src/scene/farDots'

const at = { x: 0, y: 0 }

// R-C09, R-G07
test('a dot is a ring of two half circles about its place', () => {
  expect(farDot('Q', 20, 30, 5).d).toBe('M15 30a5 5 0 1 0 10 0a5 5 0 1 0 -10 0')
})

test('dots of one look are one outline; those whose variable is gone are left out', () => {
  const dots = ['A', 'B', 'C', 'GONE'].map((svar, k) => farDot(svar, 100 * k, 0, 5))
  const drawn = dotOutlines(dots, { A: { ...at, line: 'live' }, B: at, C: { ...at, line: 'live' } })
  expect(drawn.map(({ look }) => look)).toEqual(['live', 'idle'])
  expect(drawn[0]!.d).toBe(dots[0]!.d + dots[2]!.d)
})

test('hidden lines are told by the look of the dot', () => {
  expect(lookOf({ ...at, line: 'live', is_shown: false })).toBe('live closed')
  expect(lookOf({ ...at, is_shown: false, is_constant: true })).toBe('shut')
})
