// R-D23: where the bodies of an arm are for given angles of its joints.
import { expect, test } from 'vitest'
import { hung, jointsOf, movedBodies, posture, type Hinge, type Pose } from '../../src/geom/chain'

const HERE: Pose = [0, 0, 0, 1, 0, 0, 0]
const hinge = (carrier: number, joint: string, more: Partial<Hinge> = {}): Hinge => ({
  carrier,
  position: [1, 0, 0],
  quaternion: [1, 0, 0, 0],
  joint,
  slides: false,
  axis: [0, 0, 1],
  anchor: [0, 0, 0],
  ...more,
})
const close = (pose: Pose | undefined, expected: readonly number[]): void =>
  expect(pose?.slice(0, expected.length).map((value) => Math.round(value * 1e6) / 1e6 + 0)).toEqual(expected)

/** Two links of 1 m in a plane and a hand on the second; another arm beside them. */
const ARM = new Map([
  [3, hinge(2, '')],
  [1, hinge(0, 'left.joint1', { position: [0, 0, 0] })],
  [2, hinge(1, 'left.joint2')],
  [4, hinge(0, 'right.joint1')],
])

test('a joint turns its body about its axis through its anchor', () => {
  close(hung(HERE, hinge(0, 'a'), Math.PI / 2), [1, 0, 0, Math.round(Math.SQRT1_2 * 1e6) / 1e6])
  close(hung(HERE, hinge(0, 'a', { anchor: [-1, 0, 0] }), Math.PI / 2), [0, 1, 0])
  close(hung(HERE, hinge(0, 'a', { slides: true }), 0.5), [1, 0, 0.5])
  close(hung(HERE, hinge(0, ''), 7), [1, 0, 0])
})

test('what the joints carry goes with them, and what is on it stands against it as it does now', () => {
  const now = (body: number): Pose => [body === 3 ? 2.25 : body === 2 ? 2 : 0, 0, 0, 1, 0, 0, 0]
  const poses = posture(ARM, 'left', [Math.PI / 2, 0], now)
  close(poses.get(2), [0, 1, 0])
  close(poses.get(3), [0, 1.25, 0])
  expect(poses.has(4)).toBe(false)
})

test('an arm of another count of joints, or none of this name, has no posture', () => {
  expect(posture(ARM, 'left', [1], () => HERE).size + posture(ARM, 'none', [], () => HERE).size).toBe(0)
})

test('joints stand in the order of their numbers', () => {
  const many = new Map(Array.from({ length: 11 }, (_, k) => [11 - k, hinge(0, `a.joint${11 - k}`)] as const))
  expect(jointsOf(many, 'a')).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11])
})

test('what joints move, and what stands on that, is no place of its own; a table is', () => {
  // R-D25
  expect([...movedBodies(new Map([...ARM, [9, hinge(0, '')]]))].sort()).toEqual([1, 2, 3, 4])
})
