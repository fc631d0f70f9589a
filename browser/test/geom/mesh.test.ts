// R-X19: a mesh as it travels, and its surface.
import { expect, test } from 'vitest'
import { surfaceOf } from '../../src/geom/mesh'

/** The bytes of a mesh, as `workcell.mesh.encoded` makes them. */
function bytes(corners: number[][], triangles: number[][]): ArrayBuffer {
  const numbers = [...corners.flat(), ...triangles.flat()]
  const whole = new Uint8Array(8 + 2 * numbers.length)
  whole.set(new Uint8Array(Uint32Array.of(corners.length, triangles.length).buffer))
  whole.set(new Uint8Array(Uint16Array.from(numbers).buffer), 8)
  return whole.buffer
}

const HIGH = 65535
const CORNER = bytes(
  [
    [0, 0, 0],
    [HIGH, 0, 0],
    [0, HIGH, 0],
    [0, 0, HIGH],
  ],
  [
    [0, 1, 2],
    [0, 3, 1],
  ],
)

test('corners stand within their box', () => {
  const surface = surfaceOf(CORNER, [1, 2, 3])
  expect([...surface!.corners.subarray(0, 9)]).toEqual([-1, -2, -3, 1, -2, -3, -1, 2, -3])
})

test('a sharp edge stays sharp', () => {
  const { normals } = surfaceOf(CORNER, [1, 2, 3])!
  expect([...normals.subarray(0, 3)]).toEqual([0, 0, 1])
  expect([...normals.subarray(9, 12)].map((part) => part + 0)).toEqual([0, 1, 0])
})

test('faces that bend a little look round', () => {
  const bent = bytes(
    [
      [0, 0, 0],
      [30000, 0, 0],
      [0, 30000, 0],
      [30000, 30000, 3000],
    ],
    [
      [0, 1, 2],
      [1, 3, 2],
    ],
  )
  const { normals } = surfaceOf(bent, [1, 1, 1])!
  expect([...normals.subarray(3, 6)]).toEqual([...normals.subarray(9, 12)])
})

test('what is no mesh is none', () => {
  expect(surfaceOf(new ArrayBuffer(3), [1, 1, 1])).toBeUndefined()
  expect(surfaceOf(CORNER.slice(0, 20), [1, 1, 1])).toBeUndefined()
  expect(surfaceOf(bytes([[0, 0, 0]], [[0, 0, 7]]), [1, 1, 1])).toBeUndefined()
})
