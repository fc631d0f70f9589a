// The page's copy of the tree follows the environment's, change by change.
import { beforeEach, expect, test } from 'vitest'
import { applyPatch, applySnapshot, desk } from '../../src/desk.svelte'

beforeEach(() =>
  applySnapshot({ t: 'Snapshot', rev: 1, version: '1', you: 'ada', tree: { documents: { d1: { name: 'a', order: 0 } }, clipboard: 'pd' } }),
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
  patch([['documents', 'd1', 'undo'], null], [['documents', 'd1', 'loci', 'Q'], null], [['documents', 'd9', 'tasks', 'pd', 'x'], null])
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
