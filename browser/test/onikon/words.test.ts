// What icons and types are called.
import { expect, test } from 'vitest'
import { initialsOf } from '../../src/onikon/initials'
import { groupTitle, typeTitle } from '../../src/onikon/typewords'
import { wordsOf } from '../../src/onikon/words'

test('an icon is called by its words in the language of the page, else its own, else its name', () => {
  const one = { description: 'upright', words: { es: 'erguido' } }
  expect([wordsOf(one, 'home', 'es'), wordsOf(one, 'home', 'en'), wordsOf({}, 'home', 'en')]).toEqual([
    'erguido',
    'upright',
    'home',
  ])
})

test('D22: the last word of a type says what it is; the rest stays as the syntax file has it', () => {
  expect(groupTitle('Joint object', 'target')).toBe('Joint targets')
  expect(groupTitle('Polynomial path job', 'job')).toBe('Polynomial path jobs')
  expect(groupTitle('Complete NOP', 'nop')).toBe('No-ops')
  expect(typeTitle('Cartesian object', 'target')).toBe('Cartesian target')
  expect(typeTitle('Strange thing', '')).toBe('Strange thing')
  expect(groupTitle('Odd', undefined)).toBe('Odd')
})

test('the initials of a name are those of its first two words', () => {
  expect(['above_square', 'home', 'box2_aj_right', 'aboveSquare', 'ñandú uno', '2nd', ''].map(initialsOf)).toEqual([
    'AS',
    'H',
    'BA',
    'AS',
    'ÑU',
    '2',
    '',
  ])
})
