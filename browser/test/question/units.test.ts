import { afterEach, describe, expect, it } from 'vitest'
import type { AskItem } from '../../src/api.gen'
import { desk } from '../../src/link/desk.svelte'
import { fields } from '../../src/question/question'
import { filedWord, shownRow, shownWord, unitOf } from '../../src/question/units'

const item = (more: Partial<AskItem>): AskItem => ({
  name: 'q',
  type: 'double',
  count: 1,
  unit: 'rad',
  meaning: '',
  ...more,
})
const row = (more: Partial<AskItem> = {}) => fields({ items: [item(more)], present: { q: [Math.PI / 2] } })[0]!
const prefer = (preferences: Record<string, unknown>): void => void (desk.tree.preferences = preferences)
afterEach(() => prefer({}))

describe('words of a form in degrees (G08)', () => {
  it('are shown in degrees and kept in radians, with bounds and present value', () => {
    prefer({ angle_unit: 'deg' })
    const bounded = row({ low: [-Math.PI], high: [Math.PI] })
    expect(shownRow(bounded)).toMatchObject({ low: -180, high: 180, present: 90 })
    expect(unitOf(bounded)).toBe('deg')
    expect(shownWord('1.5707963267948966', bounded)).toBe('90')
    expect(Number(filedWord('90', bounded))).toBeCloseTo(Math.PI / 2, 9)
  })

  it('stay at a bound that only the conversion would overstep', () => {
    prefer({ angle_unit: 'deg' })
    const bounded = row({ low: [-2.79253], high: [2.79253] })
    expect(Number(filedWord(shownWord('2.79253', bounded), bounded))).toBeLessThanOrEqual(2.79253)
    expect(Number(filedWord('161', bounded))).toBeGreaterThan(2.79253)
  })

  it('stay as typed where they are no numbers, or nothing is to be converted', () => {
    prefer({ angle_unit: 'deg' })
    for (const text of ['', '-', 'x', '1e', '45 apples']) expect(filedWord(text, row())).toBe(text)
    expect(filedWord('45', row({ unit: 's' }))).toBe('45')
    expect(filedWord('45', row({ type: 'string' }))).toBe('45')
    prefer({})
    expect(filedWord('0.10', row())).toBe('0.10')
  })

  it('may name another unit behind the number', () => {
    expect(Number(filedWord('45°', row()))).toBeCloseTo(Math.PI / 4, 9)
    expect(Number(filedWord('−90 deg', row()))).toBeCloseTo(-Math.PI / 2, 9)
    expect(filedWord('250 mm', row({ unit: 'm' }))).toBe('0.25')
    prefer({ angle_unit: 'deg' })
    expect(filedWord('0.5 rad', row())).toBe('0.5')
    expect(Number(filedWord('90 deg/s', row({ unit: 'rad/s' })))).toBeCloseTo(Math.PI / 2, 9)
  })

  it.each([1e-6, 0.1, 1 / 3, -2.5, 1234.5])('%f comes back as it went', (value) => {
    prefer({ angle_unit: 'deg', length_unit: 'mm' })
    for (const unit of ['rad', 'm', 'rad/s', 's'])
      expect(Number(filedWord(shownWord(String(value), row({ unit })), row({ unit })))).toBeCloseTo(value, 6)
  })
})
