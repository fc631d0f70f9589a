// R-D25: a name that was typed with blanks is met with one that can be taken.
import { expect, it } from 'vitest'
import { joined } from '../../src/files/naming'

it('proposes hyphens in the place of blanks', () => {
  expect(joined('  pick the  triangle ')).toBe('pick-the-triangle')
})
it('proposes nothing where there are none', () => {
  expect(joined(' pick ')).toBe('')
  expect(joined('')).toBe('')
})
