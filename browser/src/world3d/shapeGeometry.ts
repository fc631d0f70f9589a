// The shapes of a world as three.js draws them.
import { BoxGeometry, BufferGeometry, CapsuleGeometry, CylinderGeometry, PlaneGeometry, SphereGeometry } from 'three'
import type { Shape } from '../values/world'

/** Half of how far a plane without end is drawn, in m. */
const ENDLESS = 30

/** The shapes of a scene, a mesh as the box around it; those of other kinds (height fields) are not drawn. */
export function geometryOf({ kind, size }: Shape): BufferGeometry | undefined {
  const [a, b, c] = size
  switch (kind) {
    case 'plane':
      return new PlaneGeometry(a ? 2 * a : ENDLESS, b ? 2 * b : ENDLESS)
    case 'box':
    case 'mesh':
      return new BoxGeometry(2 * a, 2 * b, 2 * c)
    case 'sphere':
      return new SphereGeometry(a, 24, 16)
    case 'ellipsoid':
      return new SphereGeometry(1, 24, 16)
    case 'cylinder':
      return new CylinderGeometry(a, a, 2 * b, 32).rotateX(Math.PI / 2)
    case 'capsule':
      return new CapsuleGeometry(a, 2 * b, 8, 20).rotateX(Math.PI / 2)
    default:
      return undefined
  }
}
