// What gamepads, six-axis devices and keys say, in the axes of a push: x forward, y to the left, z up, turns about them.
import { axesOf, FREE, type Axes, type Pushed } from './push'

/** What is used here of a `Gamepad`. */
export interface GamepadState {
  connected: boolean
  mapping: string
  axes: readonly number[]
  buttons: readonly { pressed: boolean; value: number }[]
}

/** Buttons of the standard mapping: the lower one of four, both shoulders, both triggers, the cross. */
const [KEEP, LEFT_SHOULDER, RIGHT_SHOULDER, LEFT_TRIGGER, RIGHT_TRIGGER, CROSS_LEFT, CROSS_RIGHT] = [
  0, 4, 5, 6, 7, 14, 15,
]
/** Buttons of a six-axis device. */
const [CAP_HELD, CAP_KEEP] = [0, 1]
const REST = 0.06 // a stick that nobody touches is not quite in its middle

const isSixAxis = ({ mapping, axes }: GamepadState): boolean => mapping !== 'standard' && axes.length >= 6
const rested = (value = 0): number => (Math.abs(value) < REST ? 0 : value)

/** A pad with two sticks, or a six-axis device, which has no mapping. */
export function fromGamepad(pad: GamepadState | null | undefined): Pushed {
  if (!pad?.connected) return FREE
  return isSixAxis(pad) ? fromCap(pad) : fromSticks(pad)
}

/** Sticks move and turn, triggers go up and down; a shoulder is the dead-man. */
function fromSticks({ axes, buttons }: GamepadState): Pushed {
  const [right = 0, back = 0, turn = 0, pitch = 0] = axes.map(rested)
  const value = (button: number): number => buttons[button]?.value ?? 0
  const isDown = (button: number): boolean => buttons[button]?.pressed ?? false
  const roll = value(CROSS_RIGHT) - value(CROSS_LEFT)
  return {
    axes: axesOf([-back, -right, value(RIGHT_TRIGGER) - value(LEFT_TRIGGER), roll, -pitch, -turn]),
    isHeld: isDown(LEFT_SHOULDER) || isDown(RIGHT_SHOULDER),
    isPressed: isDown(KEEP),
  }
}

/** A cap that is pushed and turned: right, towards oneself, down are its axes; its first button is the dead-man. */
function fromCap({ axes, buttons }: GamepadState): Pushed {
  const [right = 0, back = 0, down = 0, pitch = 0, roll = 0, yaw = 0] = axes.map(rested)
  return {
    axes: axesOf([-back, -right, -down, -roll, -pitch, -yaw]),
    isHeld: buttons[CAP_HELD]?.pressed ?? false,
    isPressed: buttons[CAP_KEEP]?.pressed ?? false,
  }
}

/** Keys by their place on the keyboard: the axis that each pushes, and whither. */
export const KEYS: Readonly<Record<string, readonly [axis: number, sign: 1 | -1]>> = {
  KeyW: [0, 1],
  KeyS: [0, -1],
  KeyA: [1, 1],
  KeyD: [1, -1],
  KeyR: [2, 1],
  KeyF: [2, -1],
  KeyL: [3, 1],
  KeyJ: [3, -1],
  KeyI: [4, 1],
  KeyK: [4, -1],
  KeyU: [5, 1],
  KeyO: [5, -1],
}

/** Keys, and places of the pad on the screen, that are down: whoever holds one holds the dead-man. */
export function fromDown(down: Iterable<readonly [axis: number, sign: 1 | -1]>): Pushed {
  const axes = [0, 0, 0, 0, 0, 0]
  let isHeld = false
  for (const [axis, sign] of down) {
    axes[axis]! += sign
    isHeld = true
  }
  return { axes: axesOf(axes), isHeld, isPressed: false }
}

/** The tool, dragged in the view: `across` is where the hand went, in m of the world; so far is all of the speed. */
export function fromDrag(across: readonly [number, number, number] | undefined, all = 0.12): Pushed {
  if (!across) return FREE
  const length = Math.hypot(...across)
  const scale = 1 / Math.max(all, length)
  const [x, y, z] = across
  const axes: Axes = axesOf([x * scale, y * scale, z * scale])
  return { axes, isHeld: true, isPressed: false }
}
