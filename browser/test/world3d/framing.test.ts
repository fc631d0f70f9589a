import { Box3, PerspectiveCamera, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { distanceTo, FROM } from '../../src/world3d/framing'

const SLOPE = Math.tan((30 * Math.PI) / 360)

/** How far out of the middle of the picture the outermost corner is seen, 1: at its border. */
function outermost(box: Box3, away: number): number {
  const camera = new PerspectiveCamera(30, 1, 0.01, 1000)
  camera.up.set(0, 0, 1)
  const middle = box.getCenter(new Vector3())
  camera.position.copy(middle).addScaledVector(FROM, away)
  camera.lookAt(middle)
  camera.updateMatrixWorld()
  const { min, max } = box
  const corners = [min.x, max.x].flatMap((x) =>
    [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z))),
  )
  return Math.max(...corners.map((corner) => Math.hypot(...corner.project(camera).toArray().slice(0, 2))))
}

describe('the first view', () => {
  it.each([
    ['a tall robot', [0.3, 0.3, 2]],
    ['a long gantry', [4, 0.5, 0.5]],
    ['a deep line', [0.5, 6, 0.2]],
    ['a cube', [1, 1, 1]],
  ])('shows all of %s, and no nearer', (_, [x = 0, y = 0, z = 0]) => {
    const box = new Box3(new Vector3(1, 2, 0), new Vector3(1 + x, 2 + y, z)) // anywhere
    const away = distanceTo(box, box.getCenter(new Vector3()), SLOPE)
    expect(outermost(box, away)).toBeCloseTo(1, 6)
  })
})
