import { expect, test } from 'vitest'
import { doneActions } from '../../src/progress/doneActions'

test('a straight run says of how many actions', () => {
  expect(doneActions({ done: 4, of: 4, is_completed: true })).toBe('4 of 4 actions')
  expect(doneActions({ done: 3, of: 4, is_completed: false })).toBe('3 of 4 actions')
})

test('one that has gone round, or has left a branch out, says how many', () => {
  expect(doneActions({ done: 12, of: 4, is_completed: true })).toBe('12 actions')
  expect(doneActions({ done: 1, of: 4, is_completed: true })).toBe('1 action')
  expect(doneActions({ done: 5, of: 4, is_completed: false })).toBe('5 actions')
})
