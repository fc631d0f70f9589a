// The open configurations in their order, and the one that is shown.
import type { DocumentView } from '../api.gen'
import { desk } from '../desk.svelte'
import { here, pick } from '../here.svelte'

export const inOrder = (): [string, DocumentView][] =>
  Object.entries(desk.tree.documents).sort(([, a], [, b]) => a.order - b.order)

export const shownDocument = (): DocumentView | undefined => desk.tree.documents[here.doc]

export function show(doc: string): void {
  if (doc === here.doc) return
  here.doc = doc
  pick()
}

/** The one before or after, round and round. */
export function step(by: 1 | -1): void {
  const ids = inOrder().map(([id]) => id)
  const next = ids[(ids.indexOf(here.doc) + by + ids.length) % ids.length]
  if (next) show(next)
}

/** Keep something on show: what vanished gives way to its neighbour, what one opened oneself comes to the front. */
export function settle(known: ReadonlySet<string>): Set<string> {
  const ids = inOrder().map(([id]) => id)
  const fresh = ids.filter((id) => !known.has(id))
  if (!ids.includes(here.doc)) show(fresh[0] ?? ids.at(-1) ?? '')
  return new Set(ids)
}
