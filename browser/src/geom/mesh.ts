// A mesh as it travels, and its surface: numbers only.

/** Corners and normals of triangles, three rows of three numbers for each. */
export interface Surface {
  corners: Float32Array
  normals: Float32Array
}

const HEAD = 8 // bytes: how many corners and how many triangles
const MOST = 65535 // of sixteen bits
/** Where two faces meet more sharply than this (by the cosine of the angle between them), there is an edge. */
const EDGE = Math.cos((35 * Math.PI) / 180)

/** Of the bytes of `laws.mesh.encoded`, within a box of these half sizes about its middle; undefined where they are none. */
export function surfaceOf(bytes: ArrayBuffer, half: readonly number[]): Surface | undefined {
  if (bytes.byteLength < HEAD) return undefined
  const [count, triangles] = new Uint32Array(bytes, 0, 2)
  if (bytes.byteLength !== HEAD + 6 * (count + triangles)) return undefined
  const shares = new Uint16Array(bytes, HEAD, 3 * count)
  const places = Float32Array.from(shares, (share, k) => ((2 * share) / MOST - 1) * half[k % 3])
  const order = new Uint16Array(bytes, HEAD + 6 * count, 3 * triangles)
  if (order.some((corner) => corner >= count)) return undefined
  return smoothed(places, order, count)
}

/** Every corner of every triangle, with the mean normal of the faces at it that meet without an edge. */
function smoothed(places: Float32Array, order: Uint16Array, count: number): Surface {
  const faces = normalsOf(places, order)
  const around = facesAt(order, count)
  const corners = new Float32Array(3 * order.length)
  const normals = new Float32Array(3 * order.length)
  for (let k = 0; k < order.length; k += 1) {
    const corner = order[k]
    corners.set(places.subarray(3 * corner, 3 * corner + 3), 3 * k)
    normals.set(meanOf(faces, Math.floor(k / 3), around[corner]), 3 * k)
  }
  return { corners, normals }
}

/** The normal of each triangle, as long as the triangle is large. */
function normalsOf(places: Float32Array, order: Uint16Array): Float32Array {
  const normals = new Float32Array(order.length)
  for (let k = 0; k < order.length; k += 3) {
    const [a, b, c] = [3 * order[k], 3 * order[k + 1], 3 * order[k + 2]]
    const [ux, uy, uz] = [0, 1, 2].map((axis) => places[b + axis] - places[a + axis])
    const [vx, vy, vz] = [0, 1, 2].map((axis) => places[c + axis] - places[a + axis])
    normals.set([uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx], k)
  }
  return normals
}

function facesAt(order: Uint16Array, count: number): number[][] {
  const around = Array.from({ length: count }, (): number[] => [])
  order.forEach((corner, k) => around[corner].push(Math.floor(k / 3)))
  return around
}

function meanOf(faces: Float32Array, own: number, near: readonly number[]): [number, number, number] {
  const mean: [number, number, number] = [0, 0, 0]
  const length = (face: number): number => Math.hypot(faces[3 * face], faces[3 * face + 1], faces[3 * face + 2])
  for (const face of near) {
    const dot =
      faces[3 * face] * faces[3 * own] +
      faces[3 * face + 1] * faces[3 * own + 1] +
      faces[3 * face + 2] * faces[3 * own + 2]
    if (face !== own && dot < EDGE * length(face) * length(own)) continue
    for (let axis = 0; axis < 3; axis += 1) mean[axis] += faces[3 * face + axis]
  }
  const long = Math.hypot(...mean) || 1
  return [mean[0] / long, mean[1] / long, mean[2] / long]
}
