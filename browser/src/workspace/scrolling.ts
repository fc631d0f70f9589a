// What is dragged to the upper or lower side brings more into view.
import { workspaceState } from './workspaceState.svelte'

const NEAR = 36
const FASTEST = 14

export function edgeScroll({ clientY }: { clientY: number }): void {
  const { ground } = workspaceState
  if (!ground) return
  const { top, bottom } = ground.getBoundingClientRect()
  const over = clientY < top + NEAR ? clientY - top - NEAR : clientY > bottom - NEAR ? clientY - bottom + NEAR : 0
  if (over) ground.scrollTop += Math.max(-FASTEST, Math.min(FASTEST, over / 2))
}
