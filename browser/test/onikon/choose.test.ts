// Which icons are shown, and in which groups.
import { describe, expect, test } from 'vitest'
import type { DictionaryView, OnikonView, TypeView } from '../../src/api.gen'
import { choose, countIn, fitOf, inOrder, type Wish } from '../../src/onikon/choose'

const type = (order: number, role: TypeView['role']): TypeView => ({ order, role, left: '1', right: '1' })
const types = { 'Complete job': type(2, 'job'), 'Joint object': type(5, 'target'), 'Joint job': type(6, 'job') }
const dictionary = (path: string, order: number): DictionaryView => ({ name: path, path, order, onikons: 0 })
const dictionaries = { '/puma': dictionary('/puma', 0), '/boxes': dictionary('/boxes', 1) }
const icon = (kind: string, path: string, order: number, left: string, more: Partial<OnikonView> = {}): OnikonView => ({
  type: kind,
  role: 'job',
  order,
  dictionary: path,
  left,
  right: '1',
  picture: '',
  ...more,
})

const onikons: Record<string, OnikonView> = {
  above: icon('Joint object', '/boxes', 1, '2', {
    description: 'above the square',
    words: { es: 'sobre el cuadrado' },
  }),
  home: icon('Joint object', '/boxes', 0, '2', { description: 'upright' }),
  jmove: icon('Joint job', '/puma', 0, '1', { description: 'turn to' }),
  halfway: icon('Joint object', '/puma', 1, '2', { description: 'half of the way above' }),
  open: icon('Complete job', '/puma', 2, '1'),
  odd: icon('Odd object', '/puma', 3, '1'),
}
const entries = inOrder(onikons, types, dictionaries, 'en')
const all: Wish = { dictionary: '', wanted: '', left: undefined }
const shown = (wish: Partial<Wish>): [string, string[]][] =>
  choose(entries, { ...all, ...wish }).map(({ type, names }) => [type, names])

describe('the icons shown', () => {
  test('R-D01: are grouped by type in the order of the syntax, then of the dictionaries; unknown types come last', () => {
    expect(shown({})).toEqual([
      ['Complete job', ['open']],
      ['Joint object', ['halfway', 'home', 'above']],
      ['Joint job', ['jmove']],
      ['Odd object', ['odd']],
    ])
  })

  test('come behind those that are shipped where somebody has made them, so that these keep their places', () => {
    const first = { '/own': dictionary('/own', 0), '/boxes': { ...dictionary('/boxes', 1), is_shipped: true } }
    const made = { mine: icon('Joint object', '/own', 0, '2'), home: onikons.home!, above: onikons.above! }
    const [group] = choose(inOrder(made, types, first, 'en'), all)
    expect(group?.names).toEqual(['home', 'above', 'mine'])
  })

  test('are those of one dictionary where one is chosen', () => {
    expect(shown({ dictionary: '/boxes' })).toEqual([['Joint object', ['home', 'above']]])
  })

  test('a search looks into all dictionaries, at names, words of every language and types; beginnings come first', () => {
    expect(shown({ dictionary: '/puma', wanted: 'above' })).toEqual([['Joint object', ['above', 'halfway']]])
    expect(shown({ wanted: 'CUADRADO' })).toEqual([['Joint object', ['above']]])
    expect(shown({ wanted: 'joint job' })).toEqual([['Joint job', ['jmove']]])
    expect(shown({ wanted: 'nowhere' })).toEqual([])
  })

  test('are only those that fit, where that is wanted', () => {
    // R-D03
    expect(shown({ left: '2' })).toEqual([['Joint object', ['halfway', 'home', 'above']]])
  })
})

describe('targets that were made for an arm', () => {
  const made = { ...onikons, right: icon('Joint object', '/boxes', 4, '2', { arm: 'puma_right' }) }
  const entries = inOrder(made, types, dictionaries, 'en')
  const wish: Wish = { ...all, left: '2' }

  test('R-D08: are left out behind jobs of another arm, and counted', () => {
    const offered = choose(entries, { ...wish, hardware: ['puma', 'led_monitor'] })
    expect(offered.map(({ names }) => names)).toEqual([['halfway', 'home', 'above']])
    expect(countIn(choose(entries, wish)) - countIn(offered)).toBe(1)
  })

  test('R-D08: are offered behind jobs of theirs, and where nobody knows the arm', () => {
    expect(countIn(choose(entries, { ...wish, hardware: ['puma_right'] }))).toBe(4)
    expect(countIn(choose(entries, { ...wish, hardware: [] }))).toBe(4)
  })
})

describe('a group', () => {
  test('says that it fits here, or that it is what the hole waits for', () => {
    const gap = { left: '2', right: '1', wants: ['Joint object'], isHole: true }
    const groups = choose(entries, all)
    expect(groups.map((one) => fitOf(one, gap))).toEqual(['', 'hole', '', ''])
    expect(groups.map((one) => fitOf(one, { ...gap, wants: [] }))).toEqual(['', 'here', '', ''])
    expect(groups.map((one) => fitOf(one, undefined))).toEqual(['', '', '', ''])
  })
})

test('G07: a search in a thousand icons takes less than a frame', () => {
  const many = Object.fromEntries(
    Array.from({ length: 1000 }, (_, k) => [
      `icon_${k}`,
      icon('Joint object', '/boxes', k, '2', { description: `place number ${k}` }),
    ]),
  )
  const thousand = inOrder(many, types, dictionaries, 'en')
  const times = Array.from({ length: 9 }, (_, k) => {
    const begin = performance.now()
    expect(choose(thousand, { ...all, wanted: `number ${k}` })[0]!.names.length).toBeGreaterThan(0)
    return performance.now() - begin
  })
  expect(times.sort((a, b) => a - b)[4]).toBeLessThan(16)
})
