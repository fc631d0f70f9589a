// How a task icon shows what a task is.
import { describe, expect, test } from 'vitest'
import type { PinView } from '../../src/api.gen'
import { isSolid, looks, MARK } from '../../src/widgets/mark'
import { isInput, isLeft, OUTLINE, preference, shape } from '../../src/scene/pin'
import { rateText } from '../../src/scene/rate'

const pin = (kind: PinView['kind']): PinView => ({ name: 'p', svar: 'P', kind, y: 55 })

describe('a pin', () => {
  test('shows its kind by its shape', () => {
    // R-C02
    expect(shape(pin('INCONST'))).toBe('C')
    expect(shape(pin('OUTVAR'))).toBe('V')
    expect(shape(pin('INBOTH'))).toBe('B')
    expect(new Set(Object.values(OUTLINE)).size).toBe(3)
  })

  test('changes sides when the icon is flipped', () => {
    // R-C10
    expect(isLeft(pin('INVAR'), true)).toBe(true)
    expect(isLeft(pin('INVAR'), false)).toBe(false)
    expect(isLeft(pin('OUTVAR'), true)).toBe(false)
    expect(isLeft(pin('OUTCONST'), false)).toBe(true)
  })

  test('is an input by its kind', () => {
    expect((['INCONST', 'INVAR', 'INBOTH'] as const).every((kind) => isInput(pin(kind)))).toBe(true)
    expect((['OUTCONST', 'OUTVAR', 'OUTBOTH'] as const).some((kind) => isInput(pin(kind)))).toBe(false)
  })

  test('of both kinds is drawn while either is wanted', () => {
    // R-G01
    expect(preference(pin('OUTBOTH'))).toEqual(['show_outconst', 'show_outvar'])
    expect(preference(pin('INCONST'))).toEqual(['show_inconst'])
  })
})

describe('a rate', () => {
  // R-C02
  test.each([
    [500, false, '500 Hz'],
    [500, true, '2 ms'],
    [2000, true, '500 µs'],
    [33.33333, false, '33.33 Hz'],
    [30, true, '33.33 ms'],
    [0, false, ''],
    [undefined, true, ''],
    [null, false, ''],
  ])('%s is written, as a period: %s', (hz, showsPeriod, text) => expect(rateText(hz, showsPeriod)).toBe(text))
})

describe('a state', () => {
  // R-C25
  test('has a mark of its own', () => {
    const own = (['ON', 'OFF', 'ASKING', 'WAITING', 'ERROR'] as const).map((state) => MARK[state])
    expect(new Set(own).size).toBe(5)
  })

  test('of coming and going looks like waiting', () => {
    expect(looks('SPAWNING')).toBe('WAITING')
    expect(looks('KILLING')).toBe('WAITING')
    expect(looks('ERROR')).toBe('ERROR')
    expect(isSolid('SPAWNING')).toBe(true)
    expect(isSolid('OFF')).toBe(false)
  })
})
