import { expect, test } from 'vitest'
import { freeUnit } from '../../src/values/freeUnit'

test('a further unit gets a name of the row that no other one has', () => {
  expect(freeUnit([])).toBe('rt0')
  expect(freeUnit(['rt0', 'rt1'])).toBe('rt2')
  expect(freeUnit(['left', 'rt2'])).toBe('rt3')
})
