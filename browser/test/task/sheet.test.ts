// What is typed into the sheet, and what it says.
import { describe, expect, test } from 'vitest'
import { hertz, ties, timesPlaced, words } from '../../src/task/sheet'

describe('R-C04: a rate', () => {
  test.each([
    ['500', 500],
    ['500 Hz', 500],
    ['2 ms', 500],
    ['40us', 25000],
    ['0,5', 0.5],
    ['0.5 s', 2],
  ])('%s', (text, hz) => expect(hertz(text)).toBeCloseTo(hz, 9))
  test.each(['', 'fast', '-5', '1e3', '5 5', 'NaN', 'Infinity', '5 kHz'])('“%s” is none', (text) =>
    expect(hertz(text)).toBeNaN(),
  )
})

test('the words of a LOCAL line are separated by blanks of any length', () =>
  expect(words('  1.0   2.0\t3 ')).toEqual(['1.0', '2.0', '3']))

test('others who read and write a variable, without the task itself', () => {
  const doc = { name: 'a', order: 0, loci: { Q: { x: 0, y: 0, writers: ['puma'], readers: ['pd', 'diff'] } } }
  expect(ties(doc, 'pd', { name: 'Y', svar: 'Q', kind: 'INVAR', y: 0 })).toEqual({
    readers: ['diff'],
    writers: ['puma'],
  })
  expect(ties(undefined, 'pd', { name: 'Y', svar: 'Q', kind: 'INVAR', y: 0 })).toEqual({ readers: [], writers: [] })
})

test('a task is counted once for each configuration it stands in', () => {
  const documents = { a: { name: 'a', order: 0, tasks: { pd: { x: 0, y: 0 } } }, b: { name: 'b', order: 1 } }
  expect([timesPlaced(documents, 'pd'), timesPlaced(documents, 'diff')]).toEqual([1, 0])
})
