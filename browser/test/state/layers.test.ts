// R-G04: Esc closes what was opened last, wherever the keyboard is.
import { beforeEach, expect, test, vi } from 'vitest'
import { closeLast, closesFirst, isSomethingOpen, opened } from '../../src/state/layers'

const closed: string[] = []
const ends: (() => void)[] = []
const open = (name: string, place?: 'over' | 'beside' | 'beneath'): void => {
  const end = opened(() => {
    closed.push(name)
    end()
  }, place)
  ends.push(end)
}

beforeEach(() => {
  ends.splice(0).forEach((end) => end())
  closed.length = 0
  vi.stubGlobal('document', { activeElement: {}, body: {} })
})

test('what was opened last is closed first, and each once', () => {
  open('panel', 'beside')
  open('menu')
  for (let k = 0; k < 3; k++) closeLast()
  expect([closed, isSomethingOpen()]).toEqual([['menu', 'panel'], false])
})

test('what accompanies the work is closed last, whenever it was opened', () => {
  open('panel', 'beside')
  open('tutorial', 'beneath')
  closeLast()
  closeLast()
  expect(closed).toEqual(['panel', 'tutorial'])
})

test('what was closed otherwise is no longer there', () => {
  open('panel', 'beside')
  open('menu')
  ends.at(-1)!()
  closeLast()
  expect(closed).toEqual(['panel'])
})

test('before a selection is let go, Esc closes what lies over the work, and a panel where nothing has the keyboard', () => {
  expect(closesFirst()).toBe(false)
  open('tutorial', 'beneath')
  vi.stubGlobal('document', { activeElement: null, body: {} })
  expect(closesFirst()).toBe(false)
  open('panel', 'beside')
  expect(closesFirst()).toBe(true)
  vi.stubGlobal('document', { activeElement: {}, body: {} })
  expect(closesFirst()).toBe(false)
  open('menu')
  expect(closesFirst()).toBe(true)
})
