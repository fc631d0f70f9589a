// What a hand presses in a world and what has no shape of its own: panic buttons, a red cap each, beside what they stop,
// and switches, a blue box each, that are green while they are touched. A click presses them.
import { BoxGeometry, CylinderGeometry, Group, Mesh, MeshLambertMaterial, type BufferGeometry } from 'three'
import type { Buttons } from '../values/world'

/** Heights and radii in m, as of a button for a whole hand. */
const FOOT = { radius: 0.045, height: 0.03 }
const CAP = { radius: 0.035, height: 0.025 }
const [POST, LEAST_POST, COLUMN] = [0.015, 0.005, '#6b7280'] // what bears a button that nothing is below
const PRESSED = 0.016 // so far a cap goes down
const PANIC = { foot: '#e3b341', free: '#c8281e', pressed: '#c8281e', glow: '#c8281e' }
const SWITCH = { foot: '#8a94a3', free: '#2f6fd0', pressed: '#1f9d55', glow: '#0f5c2f' }

export class Knobs {
  readonly group = new Group()
  private readonly caps = new Map<string, { cap: Knob; colors: typeof PANIC }>()

  constructor(buttons: Buttons, switches: readonly string[] = []) {
    for (const [name, [x, y, z, ground = z]] of Object.entries(buttons)) {
      const isSwitch = switches.includes(name)
      const colors = isSwitch ? SWITCH : PANIC
      const [foot, cap] = [upright(FOOT, isSwitch, colors.foot), upright(CAP, isSwitch, colors.free)]
      foot.position.set(x, y, z + FOOT.height / 2)
      foot.name = cap.name = name
      cap.position.set(x, y, 0)
      cap.userData.free = z + FOOT.height + CAP.height / 2
      this.caps.set(name, { cap, colors })
      if (z - ground > LEAST_POST) {
        const post = upright({ radius: POST, height: z - ground }, false, COLUMN)
        post.position.set(x, y, (z + ground) / 2)
        this.group.add(post)
      }
      this.group.add(foot, cap)
    }
    this.press([])
  }

  /** These are down, and all others up. */
  press(pressed: readonly string[]): void {
    for (const [name, { cap, colors }] of this.caps) {
      const isDown = pressed.includes(name)
      cap.position.z = (cap.userData.free as number) - (isDown ? PRESSED : 0)
      cap.material.color.set(isDown ? colors.pressed : colors.free)
      cap.material.emissive.set(isDown ? colors.glow : '#000000')
    }
  }

  /** The button that an object of the drawn world belongs to. */
  of(object: unknown): string | undefined {
    return object instanceof Mesh && object.parent === this.group ? object.name : undefined
  }
}

type Knob = Mesh<BufferGeometry, MeshLambertMaterial>

function upright({ radius, height }: typeof FOOT, isBox: boolean, color: string): Knob {
  const round = new CylinderGeometry(radius, radius, height, 32).rotateX(Math.PI / 2)
  const form = isBox ? new BoxGeometry(2 * radius, 2 * radius, height) : round
  const mesh = new Mesh(form, new MeshLambertMaterial({ color }))
  mesh.castShadow = mesh.receiveShadow = true
  return mesh
}
