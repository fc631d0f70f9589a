// Finding an icon by typing.
import { describe, expect, test } from 'vitest'
import type { OnikonView } from '../../src/api.gen'
import { inOrder } from '../../src/onikon/choose'
import { countFitting, find } from '../../src/workspace/find'

const onikon = (
  type: string,
  role: OnikonView['role'],
  left: string,
  right: string,
  description: string,
  order = 0,
): OnikonView => ({ type, role, order, dictionary: '/d', left, right, picture: '', description })
const onikons: Record<string, OnikonView> = {
  opengripC: onikon('Complete job', 'job', '0', '0', 'open the hand'),
  closegripC: onikon('Complete job', 'job', '0', '0', 'close the hand', 1),
  jmoveC: onikon('Joint job', 'job', '0', '1', 'move the joints'),
  home: onikon('Joint object', 'target', '1', '0', 'straight up'),
  via: onikon('Joint object', 'target', '1', '1', 'by way of the middle', 1),
}
const types = Object.fromEntries(
  ['Complete job', 'Joint job', 'Joint object'].map((name, order) => [
    name,
    { order, role: '' as const, left: '', right: '' },
  ]),
)
const entries = inOrder(onikons, types, { '/d': { name: 'd', path: '/d', order: 0, onikons: 5 } }, 'en')
const START = { left: '0', right: '0', wants: [], isHole: false }
const HOLE = { left: '1', right: '0', wants: ['Joint object'], isHole: true }
const names = (words: string, gap: typeof START = START) => find(words, entries, onikons, gap).map((one) => one.name)

describe('what fits', () => {
  test('comes first, the others stay below', () => {
    // R-D03
    expect(names('')).toEqual(['opengripC', 'closegripC', 'jmoveC', 'home', 'via'])
    expect(find('', entries, onikons, START).map((one) => one.doesFit)).toEqual([true, true, true, false, false])
  })

  test('and fills the hole comes before what only fits', () => {
    // R-D19
    expect(names('', HOLE as unknown as typeof START).slice(0, 2)).toEqual(['home', 'via'])
  })

  test('is counted whatever was typed', () => {
    expect(countFitting(entries, START)).toBe(3)
    expect(countFitting(entries, undefined)).toBe(0)
  })
})

test('words are found in names, words and types', () => {
  expect(names('close')).toEqual(['closegripC'])
  expect(names('hand the')).toEqual(['opengripC', 'closegripC'])
  expect(names('joint')).toEqual(['jmoveC', 'home', 'via'])
  expect(names('nothing like it')).toEqual([])
})

test('what is called just as was typed comes first, then what begins so', () => {
  const more = {
    opengrip_leftC: onikon('Complete job', 'job', '0', '0', 'open the left hand'),
    slowC: onikon('Complete job', 'job', '0', '0', 'open the hand slowly'),
    ...onikons,
  }
  const all = inOrder(more, types, { '/d': { name: 'd', path: '/d', order: 0, onikons: 7 } }, 'en')
  const order = find('Open the hand', all, more, START).map(({ name }) => name)
  expect(order).toEqual(['opengripC', 'slowC', 'opengrip_leftC'])
})

describe('targets that were made for another arm', () => {
  const made = {
    ...onikons,
    right: { ...onikon('Joint object', 'target', '1', '0', 'to the right', 2), arm: 'puma_right' },
  }
  const all = inOrder(made, types, { '/d': { name: 'd', path: '/d', order: 0, onikons: 6 } }, 'en')

  test('R-D08: are left out, and the last line says how many', () => {
    const matches = find('', all, made, HOLE as unknown as typeof START, ['puma'])
    expect(matches.map(({ name }) => name)).not.toContain('right')
    expect(matches.at(-1)?.leftOut).toBe(1)
    expect(find('home', all, made, HOLE as unknown as typeof START, ['puma']).map(({ name }) => name)).toEqual(['home'])
    expect(countFitting(all, HOLE as unknown as typeof START, ['puma'])).toBe(2)
  })

  test('R-D08: are shown behind jobs of their arm, and where no target fits they stand among the rest', () => {
    const hole = HOLE as unknown as typeof START
    expect(find('', all, made, hole, ['puma_right']).map(({ name }) => name)).toContain('right')
    expect(find('', all, made, START, ['puma']).some(({ leftOut }) => leftOut)).toBe(false)
  })
})
