import { expect, test } from 'vitest'
import type { OwnChangeView, SentBackView } from '../../src/api.gen'
import { held, left, toSend } from '../../src/library/sending'

const changes: OwnChangeView[] = [{ path: 'module/a.rmod' }, { path: 'module/b.rmod' }]

test('what is left out is not sent, until it is chosen again', () => {
  const without = left([], 'module/a.rmod', false)
  expect(toSend(changes, without)).toEqual(['module/b.rmod'])
  expect(toSend(changes, left(without, 'module/a.rmod', true))).toEqual(['module/a.rmod', 'module/b.rmod'])
})

test('contradictions are told from what was merged', () => {
  const sent: SentBackView = { library: 'x', held: [{ path: 'a', contradicts: true }, { path: 'b' }] }
  expect(held(sent, true).map((file) => file.path)).toEqual(['a'])
  expect(held(sent, false).map((file) => file.path)).toEqual(['b'])
  expect(held(undefined, false)).toEqual([])
})
