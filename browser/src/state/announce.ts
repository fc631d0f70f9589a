// Words for those who do not see the page; Announcer.svelte puts them into a live region.

type Listener = (text: string) => void
const listeners = new Set<Listener>()

export function announce(text: string): void {
  for (const listener of listeners) listener(text)
}

export function onAnnounce(listener: Listener): () => void {
  listeners.add(listener)
  return () => listeners.delete(listener)
}
