// What is in files that could be opened, to be drawn in small; asked once, and again after a while: files change.
import { SvelteMap } from 'svelte/reactivity'
import type { PeekView } from '../api.gen'
import { send } from '../link/link'
import { Refusal } from '../link/refusal'

const FRESH_MS = 20_000

interface Peeked {
  at: number
  view: PeekView | undefined
  /** Why there is nothing to be seen. */
  why: string
}

const previews = new SvelteMap<string, Peeked>()

/** What is known of a file; nothing before it was asked for. */
export const peeked = (path: string): Peeked | undefined => previews.get(path)

/** Ask for it, where that was not done lately. */
export async function peek(path: string, now: number = Date.now()): Promise<void> {
  const before = previews.get(path)
  if (!path || (before && now - before.at < FRESH_MS)) return
  previews.set(path, { at: now, view: before?.view, why: before?.why ?? '' })
  try {
    const view = await send({ t: 'Peek', path })
    previews.set(path, { at: now, view: view as PeekView, why: '' })
  } catch (refused) {
    if (!(refused instanceof Refusal)) throw refused
    previews.set(path, { at: now, view: undefined, why: refused.reason })
  }
}
