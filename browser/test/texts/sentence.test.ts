import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { fill, type Value } from '../../src/texts/sentence'

interface Case {
  sentence: string
  args: Record<string, Value<never>>
  en: string
  es: string
}

const CASES = JSON.parse(
  readFileSync(new URL('../../../tests/words/sentences.json', import.meta.url), 'utf-8'),
) as Case[]

test.each(CASES)('$sentence is filled as Python fills it', ({ sentence, args, en, es }) => {
  expect(fill(sentence, args, 'en')).toBe(en)
  expect(fill(sentence, args, 'es')).toBe(es)
})

test('a missing value is said', () => {
  expect(() => fill('{a}', {}, 'en')).toThrow('expected a value of a')
})

test('a rule that does not suit is said', () => {
  expect(() => fill('{a:.2g}', { a: 'text' }, 'en')).toThrow('expected a rule')
})
