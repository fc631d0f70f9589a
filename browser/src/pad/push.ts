// What is pushed, by whatever a person holds in the hand: six axes of -1 to 1, and whether they count (K07).

export type Axes = readonly [number, number, number, number, number, number]
export type Frame = 'world' | 'tool' | 'base'
export const FRAMES: readonly Frame[] = ['world', 'tool', 'base']

/** What one device says now. */
export interface Pushed {
  axes: Axes
  /** Whether its dead-man is held. */
  isHeld: boolean
  /** Whether the button is pressed that keeps the pose. */
  isPressed: boolean
}

export const STILL: Axes = [0, 0, 0, 0, 0, 0]
export const FREE: Pushed = { axes: STILL, isHeld: false, isPressed: false }

const clipped = (value: number): number => (Number.isFinite(value) ? Math.max(-1, Math.min(1, value)) : 0)

/** Axes of any numbers. */
export const axesOf = (values: readonly number[]): Axes =>
  STILL.map((_, k) => clipped(values[k] ?? 0)) as unknown as Axes

/** All devices as one: what is held is added up, what is let go says nothing. */
export function together(devices: readonly Pushed[]): Pushed {
  const held = devices.filter(({ isHeld }) => isHeld)
  return {
    axes: axesOf(STILL.map((_, k) => held.reduce((sum, { axes }) => sum + axes[k]!, 0))),
    isHeld: held.length > 0,
    isPressed: devices.some(({ isPressed }) => isPressed),
  }
}
