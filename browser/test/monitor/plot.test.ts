import { describe, expect, it } from 'vitest'
import { csv } from '../../src/monitor/csv'
import { limits } from '../../src/monitor/limits'
import { LIVE, moved, picked, shown, wheeled } from '../../src/monitor/span'
import { spread } from '../../src/monitor/spread'

describe('the stretch of time in a plot', () => {
  it('is the newest eight seconds', () => {
    expect(shown(LIVE, 44)).toEqual([36, 44])
  })

  it('is what was dragged over, in either direction', () => {
    expect(shown(picked(LIVE, 41, 38), 44)).toEqual([38, 41])
    expect(shown(picked(LIVE, 40, 40), 44)[1]).toBeGreaterThan(40)
  })

  it('grows and shrinks with the wheel, never beyond the minute that is kept', () => {
    expect(wheeled(LIVE, 40, 1).window_s).toBeCloseTo(10)
    expect(wheeled(LIVE, 40, 99).window_s).toBe(60)
    expect(wheeled(LIVE, 40, -99).window_s).toBe(1)
  })

  it('keeps under the pointer what was there, where a range is shown', () => {
    const span = wheeled(picked(LIVE, 30, 40), 35, -3)
    const [from, to] = shown(span, 44)
    expect((35 - from) / (to - from)).toBeCloseTo(0.5)
    expect(to - from).toBeLessThan(10)
  })

  it('can be moved back in time', () => {
    expect(shown(moved(LIVE, 44, -0.25), 99)).toEqual([34, 42])
  })
})

describe('the limits of an axis', () => {
  it('are round numbers about all values', () => {
    const [low, high] = limits(-0.83, 2.94)
    expect(low).toBeLessThan(-0.83)
    expect(high).toBeGreaterThan(2.94)
    expect(low).toBe(-1)
    expect(high).toBe(4)
  })

  it('stay while they hold everything', () => {
    expect(limits(-0.5, 2.5, [-1, 3])).toEqual([-1, 3])
    expect(limits(-0.5, 3.5, [-1, 3])[1]).toBeGreaterThan(3.5)
  })

  it('shrink when they are far too wide', () => {
    expect(limits(0, 1, [-100, 100])[1]).toBeLessThan(10)
  })

  it('are sound for a constant and for nothing', () => {
    const [low, high] = limits(5, 5)
    expect(low).toBeLessThan(5)
    expect(high).toBeGreaterThan(5)
    expect(limits(Infinity, -Infinity)).toEqual([-1, 1])
    expect(limits(0, 0)[1]).toBeGreaterThan(0)
  })
})

describe('names beside lines', () => {
  it('stand apart and in the order of their lines', () => {
    const places = spread([50, 10, 12, 49], 12, 0, 100)
    const sorted = [...places].sort((a, b) => a - b)
    for (let k = 1; k < 4; k += 1) expect(sorted[k] - sorted[k - 1]).toBeGreaterThanOrEqual(12)
    expect(places[1]).toBeLessThan(places[2])
    expect(places[3]).toBeLessThan(places[0])
  })

  it('stay within the plot where there is room', () => {
    expect(Math.max(...spread([99, 98, 97], 12, 0, 100))).toBe(100)
    expect(Math.min(...spread([1, 0, 2], 12, 0, 100))).toBe(0)
  })
})

describe('a table of numbers', () => {
  it('has a row for each time and a column for each chosen element', () => {
    const stretch = { t: Float64Array.of(1, 1.0333333333), y: [Float64Array.of(1, 2), Float64Array.of(3, 4.5)] }
    expect(csv(stretch, ['Q[1]'], [1])).toBe('t_s,Q[1]\r\n1,3\r\n1.033333,4.5\r\n')
  })

  it('quotes names with commas', () => {
    expect(csv({ t: new Float64Array(0), y: [] }, ['a,"b"'], [])).toBe('t_s,"a,""b"""\r\n')
  })
})
