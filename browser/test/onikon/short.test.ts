// R-D23: values are read in a few digits.
import { expect, it } from 'vitest'
import { short } from '../../src/onikon/short'

it('shows four digits of a number', () => {
  expect(['0.70710678', '-1.5707963268', '123.456', '12345.678', '0.000123456'].map(short)).toEqual([
    '0.7071',
    '-1.571',
    '123.5',
    '12346',
    '0.0001235',
  ])
})
it('leaves what is short, whole, or no number as it is', () => {
  expect(['2.50', '1234567', 'box3', '', '0.25', '1e-3'].map(short)).toEqual([
    '2.5',
    '1234567',
    'box3',
    '',
    '0.25',
    '1e-3',
  ])
})
