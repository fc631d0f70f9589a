// The panic buttons of a world, which have no shape of their own: a red cap each, beside what it stops, that is pressed
// by a click.
import { CylinderGeometry, Group, Mesh, MeshLambertMaterial } from 'three'
import type { Buttons } from '../values/world'

/** Heights and radii in m, as of a button for a whole hand. */
const FOOT = { radius: 0.045, height: 0.03 }
const CAP = { radius: 0.035, height: 0.025 }
const PRESSED = 0.016 // so far a cap goes down

export class Knobs {
  readonly group = new Group()
  private readonly caps = new Map<string, Mesh<CylinderGeometry, MeshLambertMaterial>>()

  constructor(buttons: Buttons) {
    for (const [name, [x, y, z]] of Object.entries(buttons)) {
      const foot = upright(FOOT, '#e3b341')
      const cap = upright(CAP, '#c8281e')
      foot.position.set(x, y, z + FOOT.height / 2)
      foot.name = cap.name = name
      cap.position.set(x, y, 0)
      cap.userData.free = z + FOOT.height + CAP.height / 2
      this.caps.set(name, cap)
      this.group.add(foot, cap)
    }
    this.press([])
  }

  /** These are down, and all others up. */
  press(pressed: readonly string[]): void {
    for (const [name, cap] of this.caps) {
      const isDown = pressed.includes(name)
      cap.position.z = (cap.userData.free as number) - (isDown ? PRESSED : 0)
      cap.material.emissive.set(isDown ? '#c8281e' : '#000000')
    }
  }

  /** The button that an object of the drawn world belongs to. */
  of(object: unknown): string | undefined {
    return object instanceof Mesh && object.parent === this.group ? object.name : undefined
  }
}

function upright({ radius, height }: typeof FOOT, color: string): Mesh<CylinderGeometry, MeshLambertMaterial> {
  const mesh = new Mesh(new CylinderGeometry(radius, radius, height, 32), new MeshLambertMaterial({ color }))
  mesh.rotation.x = Math.PI / 2
  mesh.castShadow = mesh.receiveShadow = true
  return mesh
}
