// The shelf of a library: what is on it, where it stands, what of it is drawn.
import { describe, expect, test } from 'vitest'
import type { LibraryView, TaskView } from '../../src/api.gen'
import { beside, choose, columnsIn, iconHeight, seen, shelve } from '../../src/library/shelf'
import { plain } from '../../src/texts/say'

const task = (name: string, library = 'generic', order = 0, pins: string[] = []): TaskView => ({
  name,
  library,
  order,
  module: `z${name}`,
  description: `about ${name}`,
  width: 136,
  height: 100,
  pins: pins.map((svar): TaskView['pins'][number] => ({
    name: svar,
    svar,
    kind: svar.startsWith('>') ? 'OUTVAR' : 'INVAR',
    y: 0,
  })),
})
const all = (tasks: TaskView[]): Record<string, TaskView> => Object.fromEntries(tasks.map((one) => [one.name, one]))
const libraries: [string, LibraryView][] = [
  ['generic', { name: 'generic', path: '/g', order: 0, tasks: 2 }],
  ['puma', { name: 'puma', path: '/p', order: 1, tasks: 1 }],
]

describe('what is on the shelf', () => {
  const tasks = all([task('pd', 'generic', 2, ['TAU']), task('diff', 'generic', 1), task('puma', 'puma', 1, ['TAU'])])

  test('is one library in its order', () => {
    expect(choose(tasks, libraries, 'generic', '')[0]![1].map((one) => one.name)).toEqual(['diff', 'pd'])
  })

  test('R-C03: a search looks into all libraries, at names, descriptions and variables', () => {
    const found = choose(tasks, libraries, 'generic', 'tau').map(([library, some]) => [
      library,
      some.map((one) => one.name),
    ])
    expect(found).toEqual([
      ['generic', ['pd']],
      ['puma', ['puma']],
    ])
    expect(choose(tasks, libraries, 'generic', 'about diff')[0]![1].map((one) => one.name)).toEqual(['diff'])
    expect(choose(tasks, libraries, 'generic', 'nothing')).toEqual([])
  })

  test('names that begin with the word come first', () => {
    const some = all([task('a_lowpass', 'generic', 1), task('lowpass', 'generic', 2)])
    expect(choose(some, libraries, 'generic', 'low')[0]![1].map((one) => one.name)).toEqual(['lowpass', 'a_lowpass'])
  })
})

describe('where it stands', () => {
  test('R-C02: an icon grows with its pins', () => {
    expect(iconHeight(task('a'))).toBe(38)
    expect(iconHeight(task('a', 'generic', 0, ['1', '2', '3', '4', '5', '6', '7', '>8']))).toBe(12 + 7 * 8)
  })

  test('rows do not overlap and leave room for the reason', () => {
    const tasks = Array.from({ length: 7 }, (_, k) =>
      task(
        `t${k}`,
        'generic',
        k,
        Array.from({ length: k }, (_, n) => `v${n}`),
      ),
    )
    const { rows, height } = shelve([['generic', tasks]], 2, {
      t0: [{ text: plain('writes Q_REF, which jtraj already writes') }],
    })
    rows.slice(1).forEach((row, k) => expect(row.top).toBe(rows[k]!.top + rows[k]!.height))
    expect(height).toBe(rows.at(-1)!.top + rows.at(-1)!.height)
    expect(rows[0]!.title).toBe('generic')
    expect(rows[1]!.cells[0]).toMatchObject({ lines: 2, height: 38 + 2 + 25 })
    for (const row of rows) for (const cell of row.cells) expect(cell.height).toBeLessThanOrEqual(row.height)
  })

  test('as many columns as fit, and always one', () =>
    expect([50, 108, 219, 220, 400].map(columnsIn)).toEqual([1, 1, 1, 2, 3]))
})

describe('what is drawn', () => {
  const { rows, height } = shelve([['', Array.from({ length: 1000 }, (_, k) => task(`t${k}`, 'generic', k))]], 2, {})

  test('of a thousand tasks, only what the window sees', () => {
    const some = seen(rows, 5000, 5500)
    expect(some.length).toBeLessThan(15)
    expect(some[0]!.top + some[0]!.height).toBeGreaterThanOrEqual(5000)
    expect(some[0]!.top).toBeLessThanOrEqual(5000)
    expect(some.at(-1)!.top + some.at(-1)!.height).toBeGreaterThanOrEqual(5500)
  })

  test('everything where the window is as long as the shelf', () => expect(seen(rows, 0, height)).toHaveLength(500))
})

describe('R-X11: arrow keys walk', () => {
  const { rows } = shelve(
    [
      ['a', [task('1'), task('2'), task('3')]],
      ['b', [task('4')]],
    ],
    2,
    {},
  )
  test.each([
    ['1', 'ArrowRight', '2'],
    ['2', 'ArrowRight', '3'],
    ['1', 'ArrowLeft', '1'],
    ['2', 'ArrowDown', '3'],
    ['3', 'ArrowDown', '4'],
    ['4', 'ArrowDown', '4'],
    ['4', 'ArrowUp', '3'],
    ['1', 'End', '4'],
    ['4', 'Home', '1'],
    ['gone', 'ArrowDown', '1'],
  ])('%s %s %s', (from, key, to) => expect(beside(rows, from, key)).toBe(to))

  test('other keys walk nowhere', () => expect(beside(rows, '1', 'x')).toBeUndefined())
})
