import { describe, expect, it } from 'vitest'
import { NONE, percentOf, read, valuesOf } from '../../src/recording/tolerance'

describe('A tolerance', () => {
  it('is read with a point or a comma; nothing is zero', () => {
    expect(['0.5', '0,5', ' 1e-3 ', ''].map(read)).toEqual([0.5, 0.5, 0.001, 0])
  })

  it('is left to the environment where nothing is typed, or what cannot be read', () => {
    expect(valuesOf({ ...NONE, tolerance: '0,1', time_s: 'soon' })).toEqual({
      tolerance: 0.1,
      part: null,
      time_s: null,
    })
    expect(valuesOf({ ...NONE, part: '0' })).toEqual({ tolerance: null, part: 0, time_s: null })
  })

  it('by a part is typed, and shown, in percent', () => {
    expect(valuesOf({ ...NONE, part: '1,5' }).part).toBeCloseTo(0.015)
    expect([percentOf(0.01), percentOf(0.07)]).toEqual([1, 7])
  })

  it('is not read where it is no number, or less than nothing', () => {
    expect(['much', '-1', '1,2,3'].map(read)).toEqual([undefined, undefined, undefined])
  })
})
