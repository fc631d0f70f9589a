// A gesture is a state of the hand: from a press until the pointer is let go, or Esc takes it all back.

export interface Gesture {
  move(event: PointerEvent): void
  up(event: PointerEvent): void
  cancel(): void
}

/** A hand trembles: less than this is a click. */
export const STILL_PX = 4

export const hasMoved = (from: { x: number; y: number }, event: PointerEvent): boolean =>
  Math.hypot(event.clientX - from.x, event.clientY - from.y) >= STILL_PX
