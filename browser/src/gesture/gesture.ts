// A gesture is a state of the hand: from a press until the pointer is let go, or Esc takes it all back.
import type { Over } from '../scene/stage.svelte'

export interface Gesture {
  move(event: PointerEvent): void
  up(event: PointerEvent): void
  cancel(): void
}

/** A hand trembles: less than this is a click. */
export const STILL_PX = 4

export const hasMoved = (from: { x: number; y: number }, event: PointerEvent): boolean =>
  Math.hypot(event.clientX - from.x, event.clientY - from.y) >= STILL_PX

/** What lies under a pointer, told by the element that it is over. */
export function overOf(target: EventTarget | null): Over {
  const found = target instanceof Element ? target.closest<SVGElement>('[data-task], [data-locus], [data-group]') : null
  const { task, locus, group } = found?.dataset ?? {}
  if (task !== undefined) return { kind: 'task', name: task }
  if (group !== undefined) return { kind: 'group', name: group }
  return locus !== undefined ? { kind: 'locus', name: locus } : { kind: 'ground' }
}
