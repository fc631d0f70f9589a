import { expect, it } from 'vitest'
import { Marks } from '../../src/values/marks'

it('a change of state is marked when it comes, errors apart', () => {
  const marks = new Marks()
  marks.take(1, [
    ['pd', 'OFF'],
    ['diff', 'ON'],
  ])
  marks.take(2, [
    ['pd', 'ON'],
    ['diff', 'ON'],
  ])
  marks.take(3, [
    ['pd', 'ON'],
    ['diff', 'ERROR'],
  ])
  expect(marks.all).toEqual([
    { at_s: 2, task: 'pd', text: 'pd: ON', isError: false },
    { at_s: 3, task: 'diff', text: 'diff: ERROR', isError: true },
  ])
  expect(marks.of(new Set(['jtraj'])).map((mark) => mark.task)).toEqual(['diff'])
})

it('nothing is marked while no time is known, nor for a task that has just come', () => {
  const marks = new Marks()
  marks.take(NaN, [['pd', 'OFF']])
  marks.take(NaN, [['pd', 'ON']])
  marks.take(4, [
    ['pd', 'ON'],
    ['new', 'ON'],
  ])
  expect(marks.all).toEqual([])
})
