// The ring at the tool: where it can be taken, and what way in the world a way in the window is.
import { PerspectiveCamera } from 'three'
import { beforeEach, expect, test } from 'vitest'
import { Handle } from '../../src/world3d/handle'

const [WIDTH, HEIGHT] = [400, 200]
let camera: PerspectiveCamera
let handle: Handle

beforeEach(() => {
  camera = new PerspectiveCamera(90, WIDTH / HEIGHT, 0.02, 60)
  camera.up.set(0, 0, 1)
  camera.position.set(0, -2, 0)
  camera.lookAt(0, 0, 0)
  camera.updateMatrixWorld()
  handle = new Handle(camera)
})

test('it is taken where it is seen, and nowhere else', () => {
  expect(handle.isUnder(200, 100, WIDTH, HEIGHT)).toBe(false)
  handle.put([0, 0, 0])
  expect(handle.isUnder(205, 104, WIDTH, HEIGHT)).toBe(true)
  expect(handle.isUnder(260, 100, WIDTH, HEIGHT)).toBe(false)
  handle.put([0, -4, 0]) // behind who looks
  expect(handle.isUnder(200, 100, WIDTH, HEIGHT)).toBe(false)
  handle.put()
  expect(handle.isUnder(200, 100, WIDTH, HEIGHT)).toBe(false)
})

test('a way in the window is one in the plane of the picture, at the depth of the tool', () => {
  handle.put([0, 0, 0])
  const right = handle.way(250, 100, WIDTH, HEIGHT)
  expect([...right]).toEqual([expect.closeTo(1), expect.closeTo(0), expect.closeTo(0)])
  const up = handle.way(200, 50, WIDTH, HEIGHT)
  expect([...up]).toEqual([expect.closeTo(0), expect.closeTo(0), expect.closeTo(1)])
})

test('it is as large and as far away as ever, from wherever one looks', () => {
  handle.put([0, 0, 0])
  handle.turn()
  const near = handle.ring.scale.x
  handle.put([0, 2, 0])
  handle.turn()
  expect(handle.ring.scale.x).toBeCloseTo(2 * near)
  expect(handle.way(200, 100, WIDTH, HEIGHT).map((value) => Math.abs(value))).toEqual([
    expect.closeTo(0),
    expect.closeTo(0),
    expect.closeTo(0),
  ])
})
