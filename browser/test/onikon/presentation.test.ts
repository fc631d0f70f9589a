// Where words alone are shown, a run shows no pictures of icons either. R-H04
import { afterEach, expect, test } from 'vitest'
import { desk } from '../../src/link/desk.svelte'
import { signOf } from '../../src/onikon/presentation'

afterEach(() => {
  desk.live.preferences = {}
})

test('the sign of an icon is its picture, and none where a session is held to words', () => {
  desk.tree.pictures = { hand: '0123' }
  expect([signOf('hand'), signOf('gone'), signOf(undefined)]).toEqual(['0123', '', ''])
  desk.live.preferences = { presentation: 'words' }
  expect(signOf('hand')).toBe('')
  desk.live.preferences = { presentation: 'pictures' }
  expect(signOf('hand')).toBe('0123')
})
