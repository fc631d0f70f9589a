// The page's copy of the tree follows the environment's, change by change.
import { beforeEach, expect, test } from 'vitest'
import { applyPatch, applySnapshot, desk } from '../../src/link/desk.svelte'

beforeEach(() =>
  applySnapshot({
    t: 'Snapshot',
    rev: 1,
    version: '1',
    you: 'ada',
    tree: { documents: { d1: { name: 'a', order: 0 } }, clipboard: 'pd' },
  }),
)
const patch = (...changes: [string[], unknown][]): boolean => applyPatch({ t: 'Patch', rev: desk.rev + 1, changes })

test('a snapshot has every map, even those that were not sent', () => {
  expect(desk.tree.libraries).toEqual({})
  expect(desk.tree.runtime).toEqual({})
  expect(desk.tree.job_types).toEqual([])
})

test('a change deep in a branch that was empty grows the branch', () => {
  expect(patch([['documents', 'd1', 'tasks', 'pd'], { x: 1, y: 2 }])).toBe(true)
  expect(desk.tree.documents.d1?.tasks).toEqual({ pd: { x: 1, y: 2 } })
})

test('null takes away, and is no fault where there was nothing', () => {
  patch([['documents', 'd1', 'undo'], 'Move'])
  patch(
    [['documents', 'd1', 'undo'], null],
    [['documents', 'd1', 'loci', 'Q'], null],
    [['documents', 'd9', 'tasks', 'pd', 'x'], null],
  )
  expect(desk.tree.documents).toEqual({ d1: { name: 'a', order: 0 } })
})

test('null at the top is the empty value of that part, not a hole', () => {
  patch([['clipboard'], null], [['documents'], null])
  expect(desk.tree.clipboard).toBe('')
  expect(desk.tree.documents).toEqual({})
})

test('a patch out of turn changes nothing', () => {
  expect(applyPatch({ t: 'Patch', rev: 5, changes: [[['clipboard'], 'x']] })).toBe(false)
  expect([desk.rev, desk.tree.clipboard]).toEqual([1, 'pd'])
})

test('an application is exchanged when something in it changes, and what did not change stays the same', () => {
  // R-G07
  patch([['applications', 'a1'], { name: 'one', order: 0, steps: { 1: { name: 'home' }, 2: { name: 'put' } } }])
  const before = desk.tree.applications.a1!
  const [first, second] = [before.steps?.[1], before.steps?.[2]]
  patch(
    [['applications', 'a1', 'steps', '2', 'breaks'], true],
    [['applications', 'a1', 'steps', '3'], { name: 'up' }],
    [['applications', 'a1', 'flows', '0'], { steps: [1] }],
  )
  const now = desk.tree.applications.a1!
  expect(now).not.toBe(before)
  expect([now.steps?.[1], now.steps?.[2], now.steps?.[3]]).toEqual([
    { name: 'home' },
    { name: 'put', breaks: true },
    { name: 'up' },
  ])
  expect(now.steps?.[1]).toBe(first)
  expect(second).toEqual({ name: 'put' })
  expect(now.flows).toEqual({ 0: { steps: [1] } })
  patch([['applications', 'a1', 'steps', '1'], null], [['applications', 'a1', 'steps', '2', 'breaks'], null])
  expect(desk.tree.applications.a1!.steps).toEqual({ 2: { name: 'put' }, 3: { name: 'up' } })
  patch([['applications', 'a1'], null], [['onikons', 'home'], { order: 1 }])
  expect([desk.tree.applications.a1, desk.tree.onikons.home]).toEqual([undefined, { order: 1 }])
  patch([['onikons', 'home'], null])
  expect(desk.tree.onikons.home).toBeUndefined()
})
