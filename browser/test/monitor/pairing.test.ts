import { describe, expect, it } from 'vitest'
import { middle, paired } from '../../src/monitor/pairing'

const lines = ['Q_MEZ[0]', 'Q_MEZ[1]', 'Q_REF[0]', 'Q_REF[1]'].map((label) => ({ label }))
const labels = (...chosen: [string, string]): (string | undefined)[] =>
  paired(lines, ...chosen).map((line) => line?.label)

describe('reference and measurement of a scope', () => {
  // R-C14
  it('are a pair by their names before anybody has chosen', () => {
    expect(labels('', '')).toEqual(['Q_REF[0]', 'Q_MEZ[0]'])
  })

  it('are what was chosen', () => {
    expect(labels('Q_REF[1]', 'Q_MEZ[1]')).toEqual(['Q_REF[1]', 'Q_MEZ[1]'])
  })

  it('are the first two lines where no names belong together', () => {
    const [wanted, present] = paired([{ label: 'A' }, { label: 'B' }], '', '')
    expect([wanted?.label, present?.label]).toEqual(['A', 'B'])
    expect(paired([{ label: 'A' }], '', '')[1]).toBeUndefined()
  })

  it('cross a trigger that begins half way between their ends', () => {
    expect(middle({ t: [0, 1, 2], y: [-0.0977, -0.0577, -0.08] })).toBe(-0.0777)
    expect(middle({ t: [0, 1], y: [-0.02, 0.02 + 1e-16] })).toBeCloseTo(0, 12)
    expect(middle({ t: [0, 1], y: [3.5, 3.5] })).toBe(3.5)
    expect(middle({ t: [], y: [] })).toBe(0)
  })
})
