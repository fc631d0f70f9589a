// What devices say: their axes are those of a push, and nothing counts whose dead-man is not held.
import { expect, test } from 'vitest'
import { fromDown, fromDrag, fromGamepad, KEYS, type GamepadState } from '../../src/pad/devices'
import { FREE, together } from '../../src/pad/push'

const buttons = (...down: number[]): GamepadState['buttons'] =>
  Array.from({ length: 17 }, (_, k) => ({ pressed: down.includes(k), value: down.includes(k) ? 1 : 0 }))
const sticks = (axes: number[], ...down: number[]): GamepadState => ({
  connected: true,
  mapping: 'standard',
  axes,
  buttons: buttons(...down),
})

test('the left stick moves, the triggers go up and down, the right one turns', () => {
  expect(fromGamepad(sticks([0.5, -1, 0, 0], 4, 7)).axes).toEqual([1, -0.5, 1, 0, -0, -0])
  expect(fromGamepad(sticks([0, 0, 1, -0.5], 5, 6)).axes).toEqual([-0, -0, -1, 0, 0.5, -1])
})

test('a shoulder is the dead-man, and a stick at rest says nothing', () => {
  expect(fromGamepad(sticks([1, 0, 0, 0])).isHeld).toBe(false)
  expect(fromGamepad(sticks([0.05, -0.05, 0, 0], 4)).axes.every((axis) => axis === 0)).toBe(true)
  expect(together([fromGamepad(sticks([1, 0, 0, 0]))])).toEqual(FREE)
})

test('six axes without a mapping are those of a cap that is pushed and turned', () => {
  const cap = { connected: true, mapping: '', axes: [0, -1, 0.5, 0, 0, 0.3], buttons: buttons(0) }
  const { axes, isHeld } = fromGamepad(cap)
  expect(isHeld).toBe(true)
  expect(axes.map((axis) => axis + 0)).toEqual([1, 0, -0.5, 0, 0, -0.3])
})

test('a pad that is gone holds nothing', () => {
  expect(fromGamepad(null)).toEqual(FREE)
  expect(fromGamepad({ ...sticks([1, 1, 1, 1], 4), connected: false })).toEqual(FREE)
})

test('what is no number is let go', () => {
  expect(fromGamepad(sticks([NaN, -2, Infinity, 0], 4)).axes.map((axis) => axis + 0)).toEqual([1, 0, 0, 0, 0, 0])
})

test('every axis has a key for each way, and keys against each other cancel while they are held', () => {
  expect(
    Object.values(KEYS)
      .map(([axis, sign]) => `${axis}${sign}`)
      .sort(),
  ).toEqual([0, 1, 2, 3, 4, 5].flatMap((axis) => [`${axis}-1`, `${axis}1`]))
  expect(fromDown([KEYS.KeyW!, KEYS.KeyS!, KEYS.KeyA!])).toEqual({
    axes: [0, 1, 0, 0, 0, 0],
    isHeld: true,
    isPressed: false,
  })
  expect(fromDown([])).toEqual(FREE)
})

test('a drag goes where the hand is, no faster than all, and slower where it is near', () => {
  expect(fromDrag(undefined)).toEqual(FREE)
  expect(fromDrag([0.06, 0, 0], 0.12).axes.slice(0, 3)).toEqual([0.5, 0, 0])
  const [x, , z] = fromDrag([3, 0, 4], 0.12).axes
  expect([x, z]).toEqual([expect.closeTo(0.6), expect.closeTo(0.8)])
})

test('devices are added up, each with its own dead-man', () => {
  const both = together([
    fromGamepad(sticks([0, -1, 0, 0], 4)),
    fromDown([KEYS.KeyW!]),
    fromGamepad(sticks([-1, 0, 0, 0])),
  ])
  expect(both.axes.map((axis) => axis + 0)).toEqual([1, 0, 0, 0, 0, 0])
})
