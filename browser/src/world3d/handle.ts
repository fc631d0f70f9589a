// The ring at the tool, by which it is dragged: where the hand goes in the window is a way in the world (K07).
import { DoubleSide, Mesh, MeshBasicMaterial, RingGeometry, Vector3, type PerspectiveCamera } from 'three'

export type Place = readonly [number, number, number]

/** Of the height of the picture. */
const SIZE = 0.045
const GRIP = 1.6 // so much larger is where it can be taken

export class Handle {
  readonly ring = new Mesh(
    new RingGeometry(0.72, 1, 40),
    new MeshBasicMaterial({ color: '#2f7fd8', side: DoubleSide, depthTest: false, transparent: true, opacity: 0.85 }),
  )

  constructor(private readonly camera: PerspectiveCamera) {
    this.ring.visible = false
    this.ring.renderOrder = 1
  }

  /** At a place of the world in m; without one it is not there. */
  put(place?: Place): void {
    this.ring.visible = place !== undefined
    if (place) this.ring.position.set(...place)
  }

  /** As large as ever, and turned to who looks, from wherever. */
  turn(): void {
    this.ring.quaternion.copy(this.camera.quaternion)
    this.ring.scale.setScalar(SIZE * this.height)
  }

  /** Whether a point of the canvas, in px of its size, lies on it. */
  isUnder(x: number, y: number, width: number, height: number): boolean {
    if (!this.ring.visible) return false
    const [right, down, depth] = this.away(x, y, width, height)
    return depth < 1 && Math.hypot(right, down) <= SIZE * GRIP * height
  }

  /** From the tool to a point of the canvas, in the plane of the picture at the depth of the tool, in m of the world. */
  way(x: number, y: number, width: number, height: number): Place {
    const [right, down] = this.away(x, y, width, height)
    const scale = this.height / height
    const side = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0).multiplyScalar(right * scale)
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1).multiplyScalar(-down * scale)
    const { x: a, y: b, z: c } = side.add(up)
    return [a, b, c]
  }

  /** From the tool to a point of the canvas in px, and its depth, above 1 where it is not seen. */
  private away(x: number, y: number, width: number, height: number): Place {
    const seen = this.ring.position.clone().project(this.camera)
    return [x - ((seen.x + 1) / 2) * width, y - ((1 - seen.y) / 2) * height, seen.z]
  }

  /** How much of the world, in m, the picture shows from below to above at the depth of the tool. */
  private get height(): number {
    const away = new Vector3().subVectors(this.ring.position, this.camera.position)
    const depth = Math.max(0.05, away.dot(this.camera.getWorldDirection(new Vector3())))
    return 2 * depth * Math.tan((this.camera.fov * Math.PI) / 360)
  }
}
