// The refusal on show, and the place of the pointer it is shown at.
import type { Refusal } from '../link/refusal'

export interface Point {
  x: number
  y: number
}

export const refused: { why: Refusal | undefined; at: Point } = $state({ why: undefined, at: { x: 0, y: 0 } })

/** Where the pointer was last, in pixels of the window, and whether keys were pressed since. */
export const pointer: Point & { isStale: boolean } = { x: 0, y: 0, isStale: false }

/** Where the user is looking: at the pointer, or at what the keyboard is on. */
function lookedAt(): Point {
  const focus = pointer.isStale ? document.activeElement : null
  if (!focus || focus === document.body) return pointer
  const { left, bottom, width, height } = focus.getBoundingClientRect()
  const isLarge = width > window.innerWidth / 2 && height > window.innerHeight / 3
  return isLarge ? pointer : { x: left, y: bottom }
}

export function showRefusal(why: Refusal, at: Point = lookedAt()): void {
  refused.at = { x: at.x, y: at.y }
  refused.why = why
}

export function hideRefusal(): void {
  refused.why = undefined
}
