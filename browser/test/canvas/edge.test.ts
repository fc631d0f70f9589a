// What is dragged to the edge draws the paper along.
import { expect, test } from 'vitest'
import { pull } from '../../src/canvas/edge'

test('in the middle nothing moves', () => {
  expect(pull(300, 0, 600)).toBe(0)
  expect(pull(28, 0, 600)).toBe(0)
})

test('at an edge the paper comes from beyond it, faster the nearer', () => {
  expect(pull(4, 0, 600)).toBeGreaterThan(pull(20, 0, 600))
  expect(pull(596, 0, 600)).toBe(-pull(4, 0, 600))
})

test('a little beyond the edge it is never faster than at it, and farther out it stops', () => {
  expect(pull(-20, 0, 600)).toBe(pull(0, 0, 600))
  expect(pull(-60, 0, 600)).toBe(0)
})
