import { describe, expect, it } from 'vitest'
import { compact, number } from '../../src/values/compact'
import { compare, written } from '../../src/values/figures'

describe('a value in one line', () => {
  it('has about five signs for each number', () => {
    expect(number(6)).toBe('6')
    expect(number(1.5707963)).toBe('1.571')
    expect(number(-0.02)).toBe('−0.020')
    expect(number(1.2e-7)).toBe('1.2e−7')
    expect(number(NaN)).toBe('NaN')
  })

  it('shows vectors in brackets and counts what is left out', () => {
    expect(compact([0, 0.5, -1.25])).toBe('[0.000 0.500 −1.250]')
    expect(compact([1, 2, 3], 2)).toBe('[1 2 … +1]')
    expect(
      compact([
        [1, 0],
        [0, 1],
      ]),
    ).toBe('[[1 0] [0 1]]')
  })

  it('shows dust beside large numbers as nothing, and dust alone as it is', () => {
    expect(compact([1.5, 4.4e-13])).toBe('[1.500 0.000]')
    expect(compact([2e-7, 4.4e-13])).toBe('[2.0e−7 4.4e−13]')
    expect(compact([1e-9, NaN])).toBe('[1.0e−9 NaN]')
  })

  it('quotes text and says where there is nothing', () => {
    expect(compact('two words')).toBe('"two words"')
    expect(compact(undefined)).toBe('–')
  })
})

describe('a figure of a task', () => {
  it('is written with its unit', () => {
    expect(written('avg-U', 0.0214)).toEqual({ text: '2.1', unit: '%' })
    expect(written('avg-C', 0.041)).toEqual({ text: '41', unit: 'µs' })
    expect(written('ref-F', 500)).toEqual({ text: '500', unit: 'Hz' })
    expect(written('mez-F', 499.96)).toEqual({ text: '500.0', unit: 'Hz' })
    expect(written('cycle', 21992)).toEqual({ text: '21\u202f992', unit: '' })
    expect(written('rtpu', 'rt0')).toEqual({ text: 'rt0', unit: '' })
  })

  it('is a dash where there is none', () => {
    expect(written('mez-F', undefined).text).toBe('–')
    expect(written('mez-F', NaN).text).toBe('–')
  })

  it('sorts numbers by size, names as people read them, and nothing last', () => {
    expect([10, undefined, 9].sort(compare)).toEqual([9, 10, undefined])
    expect(['rt10', 'rt9'].sort(compare)).toEqual(['rt9', 'rt10'])
    expect(['', 'a'].sort(compare)).toEqual(['a', ''])
  })
})
