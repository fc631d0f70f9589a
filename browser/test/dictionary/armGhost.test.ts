// R-D23, R-D25: the ghost of an arm follows the values that are chosen.
import { expect, test } from 'vitest'
import { ghostOf, NOTHING_TAKEN, wordsOf } from '../../src/dictionary/armGhost'
import { askOf, normalOf, rowsOf } from '../../src/dictionary/values'

const JOINTS = rowsOf(
  askOf([{ name: 'endpoint', type: 'double', count: 2, low: [-1, -1], high: [1, 1], place: 'joints' }]),
)
const POSE = rowsOf(askOf([{ name: 'pose', type: 'double', count: 9, place: 'pose' }]))
const DOWN = ['0', '0', '-1', '0', '1', '0', '0.4', '0.2', '0.1']

test('joints are those of the words, beyond a limit too', () => {
  const taken = { device: 'boxes:arm', words: { endpoint: '0 0' }, joints: [] }
  expect(ghostOf(JOINTS, ['0.5', '-0.5'], taken)).toEqual({ device: 'boxes:arm', joints: [0.5, -0.5], isBeyond: false })
  expect(ghostOf(JOINTS, ['2', '0'], taken)?.isBeyond).toBe(true)
  expect(ghostOf(JOINTS, ['', '0'], taken)).toBeUndefined()
})

test('a pose has the joints that it was taken with, until somebody changes it', () => {
  const taken = { device: 'boxes:arm', words: wordsOf(POSE, DOWN, ['pose']), joints: [1, 2] }
  expect(ghostOf(POSE, DOWN, taken)).toEqual({ device: 'boxes:arm', joints: [1, 2], isBeyond: false })
  expect(ghostOf(POSE, [...DOWN.slice(0, 8), '0.3'], taken)).toBeUndefined()
  expect(ghostOf(POSE, DOWN, { ...taken, joints: [] })).toBeUndefined()
})

test('of no arm there is no ghost', () => {
  expect(ghostOf(JOINTS, ['0', '0'], NOTHING_TAKEN)).toBeUndefined()
})

test('how the tool is turned is known once a pose is filled in', () => {
  expect(normalOf(POSE, DOWN)).toEqual([0, 1, 0])
  expect(normalOf(POSE, [])).toBeUndefined()
  expect(normalOf(JOINTS, ['1', '2'])).toBeUndefined()
})
