// The keys of the line of time: they are its own where the keyboard is with it, or with nothing else.
import { toMark } from '../recording/acts'
import { review } from '../recording/review.svelte'

const SMALL = 1 / 1000 // of the whole, at least a tenth of a second

/** True where the key meant something. */
export function keyDown(event: KeyboardEvent): boolean {
  if (!review.isOpen || event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return false
  const by = event.shiftKey ? Math.max(0.1, (review.end_s - review.begin_s) * SMALL) : 1
  const deeds: Record<string, () => unknown> = {
    ' ': () => review.play(),
    ArrowRight: () => review.go(review.at_s + by),
    ArrowUp: () => review.go(review.at_s + by),
    ArrowLeft: () => review.go(review.at_s - by),
    ArrowDown: () => review.go(review.at_s - by),
    Home: () => review.go(review.begin_s),
    End: () => review.go(review.end_s),
    PageDown: () => toMark(1),
    PageUp: () => toMark(-1),
  }
  const deed = deeds[event.key]
  if (!deed) return false
  deed()
  event.preventDefault()
  event.stopPropagation()
  return true
}
