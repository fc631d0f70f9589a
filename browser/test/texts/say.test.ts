import { expect, test } from 'vitest'
import { applyPatch, desk } from '../../src/link/desk.svelte'
import { plain, contains, every, meaningOf, say, type Reason } from '../../src/texts/say'
import { fetchTranslation } from '../../src/texts/translations.svelte'

const option: Reason = {
  key: 'cli.language_option',
  text: 'in English',
  args: { languages: ['en', 'es'], default: 'en' },
}
const spanish = 'el idioma de los mensajes, en o es; en si ni esto ni ONIKA_LANG indican otro'

test('until a language has been fetched its readers are told in English', async () => {
  expect(say(option, 'es')).toBe('in English')
  await fetchTranslation('es')
  expect(say(option, 'es')).toBe(spanish)
})

test('a reason is said in the language of the page', () => {
  expect(say(option, 'es')).toBe(spanish)
  expect(say(option, 'en')).toBe('in English')
})

test('a reason within a reason is said in the same language', () => {
  expect(say({ ...option, args: { languages: [option, 'x'], default: option } }, 'es')).toContain(
    `, ${spanish} o x; ${spanish}`,
  )
})

test('what is in no catalogue is shown as it came', () => {
  expect(say(plain('a text'), 'es')).toBe('a text')
  expect(say(undefined, 'es')).toBe('')
  expect(say({ key: 'plain', text: 'no such file' }, 'es')).toBe('no such file')
  expect(say({ key: 'cli.of_a_newer_version', text: 'it is so' }, 'es')).toBe('it is so')
  expect(say({ key: option.key, text: 'it is so', args: {} }, 'es')).toBe('it is so')
})

test('the sentence of a module is said as the catalogue beside its code has it', () => {
  const path = ['module_sentences', 'lift']
  applyPatch({
    t: 'Patch',
    rev: desk.rev + 1,
    changes: [
      [
        path,
        { es: { '{n:plural:floor|floors} of {why}': '{n:plural:piso|pisos} de {why}', 'up: {a}': 'arriba: {a}' } },
      ],
    ],
  })
  const bare: Reason = { key: 'module:lift:up: {a}', text: 'up: {a}' }
  const reason: Reason = {
    key: 'module:lift:{n:plural:floor|floors} of {why}',
    text: 'floors of up: {a}',
    args: { n: 2, why: bare },
  }
  expect(say(reason, 'es')).toBe('pisos de arriba: {a}')
  expect(say(reason, 'en')).toBe('floors of up: {a}')
  expect(say({ ...bare, key: 'module:lift:down' }, 'es')).toBe('up: {a}')
  expect(say({ ...bare, key: 'module:door:up: {a}' }, 'es')).toBe('up: {a}')
  applyPatch({ t: 'Patch', rev: desk.rev + 1, changes: [[[...path, 'es', 'up: {a}'], 'hacia arriba: {a}']] })
  expect(say(reason, 'es')).toBe('pisos de hacia arriba: {a}')
})

test('names stand without the marks of terminals', () => {
  const written: Reason = {
    key: 'rules.output_written',
    text: 'writes X, which `cubic` already writes',
    args: { svar: 'X', other: 'cubic' },
  }
  expect(say(written, 'en')).toBe('writes X, which cubic already writes')
  expect(say(written, 'es')).toBe('escribe X, que cubic ya escribe')
})

test('the reasons within a reason are at hand', () => {
  const inner: Reason = { key: 'test.inner', text: 'too hot' }
  const outer: Reason = {
    key: 'test.outer',
    text: 'cycle: too hot',
    args: { n: 2, why: { ...option, args: { all: ['a', inner] } } },
  }
  expect(every(outer).map(({ key }) => key)).toEqual(['test.outer', option.key, 'test.inner'])
  expect([contains(outer, { ...inner }), contains(inner, outer), contains(outer, plain('too hot'))]).toEqual([
    true,
    false,
    true,
  ])
  expect([contains(plain('too hot'), plain('too hot')), contains(inner, inner)]).toEqual([true, true])
  const bare: Reason = { key: 'test.outer', text: 'cycle: no glass', args: { why: 'no glass' } }
  expect([contains(bare, { key: 'plain', text: 'no glass' }), contains(bare, inner)]).toEqual([true, false])
})

test('what an input means is said as any module translates it, else as it stands in the code', () => {
  const words = { es: { 'where to go': 'adónde ir' } }
  applyPatch({ t: 'Patch', rev: desk.rev + 1, changes: [[['module_sentences', 'jtraj'], words]] })
  expect(meaningOf('where to go', 'es')).toBe('adónde ir')
  expect(meaningOf('where to go', 'en')).toBe('where to go')
  expect(meaningOf('toString', 'es')).toBe('toString')
})
