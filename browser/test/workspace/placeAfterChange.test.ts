// R-D19: the insertion cursor stays where one worked, also when its icon is taken back.
import { describe, expect, it } from 'vitest'
import { placeAfterChange, type Flows } from '../../src/workspace/placeAfterChange'

const none = (_step: number): boolean => false
const before: Flows = { 0: [1, 2, 3, 4], '0/3/1': [5, 6] }
const after = (flow: string, step: number, now: Flows, isHole = none) =>
  placeAfterChange({ flow, after: step }, before, now, isHole)

describe('the insertion cursor when its icon is gone', () => {
  it('stays where its icon stands, and at the start', () => {
    expect(after('0', 4, { 0: [9, 4] })).toEqual({ flow: '0', after: 4 })
    expect(after('0', 0, { 0: [] })).toEqual({ flow: '0', after: 0 })
  })
  it('goes behind the nearest one before it that is left', () => {
    expect(after('0', 4, { 0: [1, 2] })).toEqual({ flow: '0', after: 2 })
    expect(after('0', 4, { 0: [1, 2] }, (step) => step === 2)).toEqual({ flow: '0', after: 1 })
  })
  it('goes to the start where none is left, or none is known', () => {
    expect(after('0', 3, { 0: [4] })).toEqual({ flow: '0', after: 0 })
    expect(after('0', 77, { 0: [1] })).toEqual({ flow: '0', after: 0 })
  })
  it('leaves a branch that is gone towards what stood before it', () => {
    expect(after('0/3/1', 6, { 0: [1, 2, 4] })).toEqual({ flow: '0', after: 2 })
    expect(after('1', 6, { 0: [1] })).toEqual({ flow: '0', after: 0 })
  })
})
