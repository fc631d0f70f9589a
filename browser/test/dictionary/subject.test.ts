// What the icon panel is about, and what it sends; the kinds that can be made by hand, and where they are kept.
import { beforeEach, describe, expect, test } from 'vitest'
import { desk } from '../../src/link/desk.svelte'
import { basesOf } from '../../src/dictionary/bases'
import { kindsOf } from '../../src/onikon/kinds'
import { changing, contentOf, keyOf, subjectOf } from '../../src/dictionary/subject'
import { workspace } from '../../src/state/workspace.svelte'

const target = { type: 'Joint object', role: 'target', left: '2', right: '1', picture: '' } as const

describe('what the panel is about', () => {
  beforeEach(() => {
    workspace.app = 'a1'
    desk.tree.onikons = { home: { ...target, order: 0, dictionary: '/d' } }
    desk.tree.applications = {
      a1: { name: 'pick', order: 0, steps: { 3: { ...target, name: 'home' }, 4: { kind: 'hole' } } },
      a2: { name: 'busy', order: 1, is_running: true, steps: { 7: { ...target, name: 'home' } } },
    }
  })

  test('is an icon of a dictionary, or one step of the application shown', () => {
    expect(subjectOf({ onikon: 'home' })).toMatchObject({ name: 'home', application: '', isRunning: false })
    expect(subjectOf({ step: '3' })).toMatchObject({ name: 'home', application: 'pick', isRunning: false })
  })

  test('R-D18: is locked while its application runs', () =>
    expect(subjectOf({ step: '7', doc: 'a2' })?.isRunning).toBe(true))

  test('is nothing where it is gone, and never a hole', () => {
    expect([subjectOf({ onikon: 'away' }), subjectOf({ step: '99' }), subjectOf({ step: '4' }), subjectOf({})]).toEqual(
      [undefined, undefined, undefined, undefined],
    )
  })

  test('R-D17: a step is changed alone, an icon in its dictionary', () => {
    expect(changing({ step: '3' }, { description: 'up' })).toEqual({
      t: 'EditIcon',
      doc: 'a1',
      step: 3,
      description: 'up',
    })
    expect(changing({ onikon: 'home' }, { picture: '8' })).toEqual({ t: 'EditOnikon', onikon: 'home', picture: '8' })
  })

  test('R-X10: what another changes of it meanwhile is seen, its place is not', () => {
    const one = desk.tree.onikons.home!
    expect(contentOf({ ...one, order: 5 })).toBe(contentOf(one))
    for (const change of [{ description: 'up' }, { values: [['1']] }, { picture: '8' }])
      expect(contentOf({ ...one, ...change })).not.toBe(contentOf(one))
  })

  test('what is begun of one is not taken for that of another', () => {
    expect(new Set([keyOf({ step: '3' }), keyOf({ step: '3', doc: 'a2' }), keyOf({ onikon: '3' })]).size).toBe(3)
  })
})

test('R-D08: targets come first among the kinds that can be made, then what does nothing; jobs are not among them', () => {
  const type = (order: number, role: 'job' | 'nop' | 'target') => ({ order, role, left: '1', right: '1' })
  const kinds = kindsOf({ nop: type(1, 'nop'), path: type(5, 'target'), job: type(2, 'job'), joint: type(3, 'target') })
  expect(kinds.map(([name]) => name)).toEqual(['joint', 'path', 'nop'])
})

test('a target is not offered to be kept in what comes with Onika', () => {
  const one = (name: string, order: number, is_shipped: boolean) => ({
    name,
    path: `/${name}`,
    order,
    onikons: 0,
    is_shipped,
  })
  expect(
    basesOf([one('mine', 2, false), one('boxes', 1, true), one('first', 0, false)]).map(({ name }) => name),
  ).toEqual(['first', 'mine'])
})
