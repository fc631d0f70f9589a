import { expect, test } from 'vitest'
import { age, ago } from '../../src/board/ages'

test('an age is said in seconds, minutes and hours', () => {
  expect([age(2), age(59.9), age(61), age(3720)]).toEqual(['just now', '59 s', '1 min', '1 h 2 min'])
})

test('what was just now is not just now ago', () => {
  expect([ago(2), ago(7)]).toEqual(['just now', '7 s ago'])
})
