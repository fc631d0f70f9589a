// The values of a target as a form of words.
import { describe, expect, test } from 'vitest'
import type { ItemView } from '../../src/api.gen'
import { ValuesDraft } from '../../src/dictionary/form.svelte'
import { askOf, begun, degrees, labelOf, lacking, nested, rowsOf, taken } from '../../src/dictionary/values'

const endpoint: ItemView = {
  name: 'endpoint',
  type: 'double',
  count: 3,
  unit: 'rad',
  low: [-1, -2, -3],
  high: [1, 2, 3],
}
const duration: ItemView = { name: 'duration', type: 'double', count: 1, unit: 's', low: [0.1], default: [2] }
const rows = rowsOf(askOf([endpoint, duration]))

describe('the form of a target (D08)', () => {
  test('has a word for each element: what is there, else what the item begins with', () => {
    expect(begun(rows)).toEqual(['', '', '', '2'])
    expect(begun(rows, [['0.5', '1', '1.5'], ['4']])).toEqual(['0.5', '1', '1.5', '4'])
  })

  test('gives the words back item by item, in the order of the type', () => {
    expect(nested(rows, ['1', '2', '3', '4'])).toEqual([['1', '2', '3'], ['4']])
  })

  test('knows which word is wrong first', () => {
    const draft = new ValuesDraft([endpoint, duration], [['0', '9', '0'], ['0']])
    expect(draft.firstWrong).toBe(1)
    draft.words[1] = '2'
    expect(draft.firstWrong).toBe(3)
    draft.words[3] = '0.1'
    expect(draft.firstWrong).toBe(-1)
  })

  test('calls elements by their place, or by what the meaning names', () => {
    expect(rows.map(labelOf)).toEqual(['[0]', '[1]', '[2]', 'duration'])
    expect(rowsOf(askOf([{ ...endpoint, meaning: 'position: x, y, z' }])).map(labelOf)).toEqual(['x', 'y', 'z'])
    expect(rowsOf(askOf([{ ...endpoint, meaning: 'where, in the end' }])).map(labelOf)).toEqual(['[0]', '[1]', '[2]'])
  })
})

describe('angles', () => {
  test('are shown in degrees beside, and nothing else is', () => {
    expect(degrees('-1.570796', 'rad')).toBe('−90°')
    expect(degrees('0.5', 's')).toBe('')
    expect(degrees('', 'rad')).toBe('')
    expect(degrees('x', 'rad')).toBe('')
  })
})

describe('what is taught (D13)', () => {
  test('fills in what was measured and leaves the rest', () => {
    expect(taken(rows, ['', '', '', '7'], { endpoint: [0.1, 0.2, 1 / 3] })).toEqual(['0.1', '0.2', '0.3333333', '7'])
  })

  test('is written without the dust of the last places, whatever its size', () => {
    const of = (values: number[]): string[] => taken(rows, [], { endpoint: values }).slice(0, 3)
    expect(of([-1.1069e-17, -1.5707963267, 2.7e-13])).toEqual(['0', '-1.570796', '0'])
    expect(of([1.23456789e-7, 0, -5e-9])).toEqual(['1.234568e-7', '0', '-5e-9'])
    expect(of([0, 0, 0])).toEqual(['0', '0', '0'])
  })

  test('R-D23: asks for what nothing measures, unless it is there', () => {
    expect(lacking(rows, { endpoint: [0, 0, 0] })).toEqual(['duration'])
    const draft = new ValuesDraft([endpoint, { ...duration, default: null }])
    expect(draft.take({ values: { endpoint: [0, 0, 0] } })).toEqual(['duration'])
    expect(draft.words).toEqual(['0', '0', '0', ''])
    expect(draft.rows.map((row) => row.present)).toEqual([0, 0, 0, undefined])
    expect(new ValuesDraft([endpoint, duration]).take({ values: { endpoint: [0, 0, 0] } })).toEqual([])
  })
})
