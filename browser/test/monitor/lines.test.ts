import { expect, it } from 'vitest'
import { clock, copied, filtered } from '../../src/monitor/lines'
import { plain } from '../../src/texts/say'

const LINES = [
  { level: 'info', text: plain('pd is placed'), at_s: 0 },
  { level: 'error', text: plain('diff: Q_MEZ jumped'), at_s: 61 },
]

it('a line is found by any of its words, in any case, and by its level', () => {
  expect(filtered(LINES, 'PLACED')).toEqual([LINES[0]])
  expect(filtered(LINES, 'jumped diff')).toEqual([LINES[1]])
  expect(filtered(LINES, 'error')).toEqual([LINES[1]])
  expect(filtered(LINES, '')).toEqual(LINES)
  expect(filtered(LINES, 'diff placed')).toEqual([])
})

it('what is copied is one line each: time, level, text', () => {
  expect(copied(LINES)).toBe(`${clock(0)}\tinfo\tpd is placed\n${clock(61)}\terror\tdiff: Q_MEZ jumped\n`)
})

it('a time is that of the day', () => {
  expect(clock(new Date(2024, 4, 1, 7, 5, 9).getTime() / 1000)).toBe('07:05:09')
})
