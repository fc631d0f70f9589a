import { describe, expect, it } from 'vitest'
import { factorNamed, factorOf, scaleOf, shownStretch, shownValue } from '../../src/values/units'
import { RATES, UNITS } from '../../src/values/units.gen'

const DEG = { angle_unit: 'deg', length_unit: 'mm' }

describe('units of people (G08)', () => {
  it('are those of files where nothing else, or nothing known, is preferred', () => {
    for (const choices of [{}, { angle_unit: 'rad', length_unit: 'm' }, { angle_unit: 'furlong' }])
      expect(scaleOf('rad/s', choices)).toEqual({ name: 'rad/s', factors: [1], isPlain: true })
  })

  it('are there for every unit of the table, also as rates, and go forth and back', () => {
    for (const [preference, units] of Object.entries(UNITS))
      for (const [name, factor] of Object.entries(units))
        for (const rate of RATES) {
          const filed = Object.keys(units)[0]! + rate
          expect(scaleOf(filed, { [preference]: name })).toMatchObject({ name: name + rate, factors: [factor] })
          expect(factorNamed(name + rate, filed)).toBe(factor)
          for (const value of [1e-7, -0.3, 12345.678]) expect((value * factor) / factor).toBeCloseTo(value, 12)
        }
  })

  it('leave other units alone', () => {
    for (const unit of ['-', 'N m/rad', 's', 'radish', 'deg', 'm, deg'])
      expect(scaleOf(unit, DEG, 4).isPlain).toBe(true)
  })

  it('are told element by element where a list names them all', () => {
    const scale = scaleOf('m,m/s,N', DEG, 3)
    expect(scale.name).toBe('mm,mm/s,N')
    expect(shownValue([1, 2, 3], scale)).toEqual([1000, 2000, 3])
    expect([0, 1, 2].map((k) => factorOf(scale, k))).toEqual([1000, 1000, 1])
  })

  it('are those of values, of matrices, and of nothing that is no number', () => {
    const scale = scaleOf('m', DEG)
    expect(
      shownValue(
        [
          [1, 2],
          [3, 4],
        ],
        scale,
      ),
    ).toEqual([
      [1000, 2000],
      [3000, 4000],
    ])
    expect(shownValue('open', scale)).toBe('open')
    expect(shownValue(undefined, scale)).toBeUndefined()
  })

  it('are those of a plotted past, which itself stays as it is', () => {
    const past = { t: Float64Array.of(0, 1), y: [Float64Array.of(1, 2), Float64Array.of(3, 4)] }
    const shown = shownStretch(past, [1000, 1])
    expect([...shown.y[0]!]).toEqual([1000, 2000])
    expect(shown.y[1]).toBe(past.y[1])
    expect([...past.y[0]!]).toEqual([1, 2])
    expect(shownStretch(past, [1, 1])).toBe(past)
  })
})
