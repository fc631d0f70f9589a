// What the pointer is over on the canvas.
import type { Over } from './canvasState.svelte'

/** What lies under a pointer, told by the element that it is over. */
export function overOf(target: EventTarget | null): Over {
  const element =
    target instanceof Element ? target.closest<SVGElement>('[data-task], [data-locus], [data-group]') : null
  const { task, locus, group } = element?.dataset ?? {}
  if (task !== undefined) return { kind: 'task', name: task }
  if (group !== undefined) return { kind: 'group', name: group }
  return locus !== undefined ? { kind: 'locus', name: locus } : { kind: 'ground' }
}
