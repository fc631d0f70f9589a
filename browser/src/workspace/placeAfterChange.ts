// Where the insertion cursor goes when the icon that it stood behind is gone.
import type { Place } from '../state/workspace.svelte'

/** The numbers of the steps of each flow, by its path. */
export type Flows = Readonly<Record<string, readonly number[]>>

/** Behind the nearest icon before it that is left, as the flows stood `before`; where the flow is gone too, behind what stood before its branch. */
export function placeAfterChange(
  { flow, after }: Place,
  before: Flows,
  now: Flows,
  isHole: (step: number) => boolean,
): Place {
  const there = now[flow]
  if (there && (!after || there.includes(after))) return { flow, after }
  if (there) {
    const stood = before[flow] ?? []
    const left = stood
      .slice(0, Math.max(0, stood.indexOf(after)))
      .filter((step) => there.includes(step) && !isHole(step))
    return { flow, after: left.at(-1) ?? 0 }
  }
  const parts = flow.split('/')
  if (parts.length < 3) return { flow: '0', after: 0 }
  return placeAfterChange({ flow: parts.slice(0, -2).join('/'), after: Number(parts.at(-2)) }, before, now, isHole)
}
