// Address, palette, preferences, memory, look: small things of the page.
import { afterEach, describe, expect, test, vi } from 'vitest'
import { desk, fullTree } from '../../src/link/desk.svelte'
import { destination, reveal } from '../../src/act/reveal.svelte'
import { canvas } from '../../src/state/canvas.svelte'
import { dialogs } from '../../src/state/dialogs.svelte'
import { keep, kept } from '../../src/state/kept'
import { read, written } from '../../src/shell/address'
import { inOrder, settle, show, step } from '../../src/act/documents.svelte'
import { find, type Entry } from '../../src/shell/palette'
import { grouped, typed } from '../../src/shell/preferences'
import { applyTheme } from '../../src/shell/applyTheme'

describe('the address of the page', () => {
  test.each([
    ['#/config/joint_move?task=pd', { kind: 'config', name: 'joint_move', task: 'pd' }],
    ['#/config/joint_move', { kind: 'config', name: 'joint_move', task: '' }],
    ['#/config/a%20b', { kind: 'config', name: 'a b', task: '' }],
    ['#/config/100%', { kind: 'config', name: '100%', task: '' }],
    ['#/appl/assemble', { kind: 'appl', name: 'assemble', task: '' }],
    ['#appl=assemble', { kind: 'appl', name: 'assemble', task: '' }],
  ])('%s', (hash, place) => expect(read(hash)).toEqual(place))
  test.each(['', '#', '#/other/x', '#/config/'])('“%s” names nothing', (hash) => expect(read(hash)).toBeUndefined())
  test('what is written is read', () => {
    const places = [
      { kind: 'config', name: 'a b/ñ?', task: 'Q^_MEZ & co' },
      { kind: 'appl', name: 'two arms', task: '' },
    ] as const
    for (const place of places) expect(read(written(place))).toEqual(place)
  })
})

describe('the palette', () => {
  const entry = (label: string, kind: string, note = ''): Entry => ({
    id: label + kind,
    label,
    kind,
    note,
    run: () => undefined,
  })
  const all = [
    entry('Undo', 'command'),
    entry('gravcomp', 'task', 'Torque against gravity'),
    entry('grav', 'file'),
    entry('antigrav', 'task'),
  ]
  test('finds by all words, the best first', () => {
    expect(find(all, 'grav').map((one) => one.label)).toEqual(['grav', 'gravcomp', 'antigrav'])
    expect(find(all, 'TORQUE task').map((one) => one.label)).toEqual(['gravcomp'])
    expect(find(all, 'grav undo')).toEqual([])
  })
  test('has everything where nothing is wanted, in its order', () => expect(find(all, ' ')).toEqual(all))
})

describe('R-G01: preferences', () => {
  test('stand in groups, and none is left out', () => {
    const preferences = { pin_length: 12, shows_period: false, status_columns: ['cycle'], news: 'x' }
    const names = grouped(preferences).flatMap(([, fields]) => fields.map((field) => field.name))
    expect(names.sort()).toEqual(Object.keys(preferences).sort())
    expect(grouped(preferences).at(-1)![0]).toBe('prefer.others')
    expect(grouped({ presentation: '' }), 'what a study fixes is nobody’s to choose').toEqual([])
  })
  test('keep their kind when they are typed', () => {
    expect(typed('14', 12)).toBe(14)
    expect(typed('1,5', 12)).toBe(1.5)
    expect(typed('long', 12)).toBeUndefined()
    expect(typed('', 12)).toBeUndefined()
    expect(typed('cycle, miss', ['rmod'])).toEqual(['cycle', 'miss'])
  })
})

describe('what this browser keeps', () => {
  afterEach(() => vi.unstubAllGlobals())
  const store = (texts: Record<string, string>): void =>
    void vi.stubGlobal('localStorage', {
      getItem: (name: string) => texts[name] ?? null,
      setItem: (name: string, text: string) => (texts[name] = text),
    })

  test('comes back', () => {
    store({})
    keep('theme', 'dark')
    expect(kept('theme', 'auto')).toBe('dark')
  })
  test('is the default where it is nonsense or of another kind', () => {
    store({ 'onika.theme': '{', 'onika.sizes': '[1]', 'onika.sounds': '"yes"' })
    expect([kept('theme', 'auto'), kept('sizes', { a: 1 }), kept('sounds', true)]).toEqual(['auto', { a: 1 }, true])
  })
  test('has the defaults of parts that it does not know yet', () => {
    store({ 'onika.sizes': '{"a":5}' })
    expect(kept('sizes', { a: 1, b: 2 })).toEqual({ a: 5, b: 2 })
  })
})

describe('open configurations', () => {
  const open = (...names: string[]): void => {
    desk.tree = fullTree({ documents: Object.fromEntries(names.map((name, order) => [name, { name, order }])) })
  }
  test('one is always shown: the one that came, or the neighbour of the one that went', () => {
    open('a', 'b')
    let known = settle(new Set())
    expect(canvas.doc).toBe('a')
    show('b')
    open('a')
    known = settle(known)
    expect(canvas.doc).toBe('a')
    open('a', 'c')
    settle(known)
    expect(canvas.doc).toBe('a') // somebody else opened it
  })
  test('are walked round and round', () => {
    open('a', 'b', 'c')
    show('c')
    step(1)
    expect(canvas.doc).toBe('a')
    step(-1)
    expect([canvas.doc, inOrder().map(([id]) => id)]).toEqual(['c', ['a', 'b', 'c']])
  })
})

describe('R-X01: a remedy leads to what it names', () => {
  test('a task, a pin of a placed task, a pin of a library task, a variable, a source', () => {
    desk.tree = fullTree({ documents: { d: { name: 'd', order: 0, tasks: { pd: { x: 0, y: 0 } } } } })
    reveal({ t: 'ShowTask', task: 'pd' }, 'd')
    expect([[...canvas.picked], canvas.doc]).toEqual([['pd'], 'd'])
    reveal({ t: 'ShowPin', task: 'diff', pin: 'Y' })
    expect([[...canvas.picked], canvas.libraryTask]).toEqual([[], 'diff'])
    reveal({ t: 'ShowPin', task: 'pd', pin: 'TAU' })
    expect([...canvas.picked]).toEqual(['pd'])
    reveal({ t: 'ShowLocus', svar: 'Q_MEZ' })
    expect(canvas.pickedLocus).toBe('Q_MEZ')
    reveal({ t: 'ShowSource', task: 'pd', line: 0 })
    expect(dialogs.current).toEqual({ name: 'source', data: { task: 'pd', kind: 'code' } })
    reveal({ t: 'ShowSource', task: 'pd', line: 7 })
    expect(dialogs.current.data).toEqual({ task: 'pd', kind: 'code', line: '7' })
    const { turn } = destination
    reveal({ t: 'ShowTask', task: 'pd' })
    reveal({ t: 'ShowTask', task: 'pd' })
    expect(destination).toEqual({ show: { t: 'ShowTask', task: 'pd' }, doc: 'd', turn: turn + 2 })
  })
})

test('the looks of 1994 and without colour are light ones, and leave nothing behind', () => {
  const worn = new Set(['dark'])
  const root = {
    classList: {
      remove: (...names: string[]) => names.forEach((name) => worn.delete(name)),
      add: (...names: string[]) => names.forEach((name) => worn.add(name)),
    },
  }
  applyTheme('1994', root as unknown as Element)
  expect([...worn]).toEqual(['light', 'y1994'])
  applyTheme('monochrome', root as unknown as Element)
  expect([...worn]).toEqual(['light', 'monochrome'])
  applyTheme('auto', root as unknown as Element)
  expect([...worn]).toEqual([])
})
