// R-G03: every text in English and in Spanish, with the same values in it.
import { readdirSync, readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { en, type TextKey } from '../../src/texts/en'
import { texts as es } from '../../src/texts/es'
import { fill } from '../../src/texts/index.svelte'

const keys = Object.keys(en) as TextKey[]
const values = (text: string): string[] =>
  [...new Set([...text.matchAll(/\{(\w+)\}/g)].map((found) => found[1]!))].sort()

test('both catalogues have the same texts', () => expect(Object.keys(es).sort()).toEqual([...keys].sort()))

test('both have the same values in each text', () => {
  expect(keys.filter((key) => String(values(es[key])) !== String(values(en[key])))).toEqual([])
})

test('no text is empty', () => expect(keys.filter((key) => !en[key].trim() || !es[key].trim())).toEqual([]))

test('values are filled in, and what has none stays to be seen', () => {
  expect(fill('{name} writes {svar}', { name: 'pd', svar: 'TAU' })).toBe('pd writes TAU')
  expect(fill('{name}', {})).toBe('{name}')
})

test('one and many differ', () => {
  expect(['0', '1', '2'].map((n) => fill('{n} task|{n} tasks', { n: Number(n) }))).toEqual([
    '0 tasks',
    '1 task',
    '2 tasks',
  ])
})

test('no two parts of the page have a text of the same name', () => {
  const folder = new URL('../../src/texts/', import.meta.url)
  const names = readdirSync(folder)
    .filter((file) => /^en\..+\.ts$/.test(file))
    .flatMap((file) =>
      [...readFileSync(new URL(file, folder), 'utf8').matchAll(/^ {2}'([^']+)':/gm)].map((found) => found[1]!),
    )
  expect(names.filter((name, k) => names.indexOf(name) !== k)).toEqual([])
})
