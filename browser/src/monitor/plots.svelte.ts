// The cells of the strip beside the table: plots of variables as `DOC/NAME`, workcells as `world:NAME`.
import { here } from '../state/here.svelte'
import { send } from '../link/link'

const WORLD = 'world:'

export type Cell = { key: string; kind: 'variable'; doc: string; name: string } | { key: string; kind: 'world'; name: string }

/** The key of a variable; a bare name belongs to the document shown. */
export const keyOf = (name: string, doc: string = here.doc): string => (name.includes('/') ? name : `${doc}/${name}`)

export function cellOf(entry: string): Cell {
  if (entry.startsWith(WORLD)) return { key: entry, kind: 'world', name: entry.slice(WORLD.length) }
  const key = keyOf(entry)
  const slash = key.indexOf('/')
  return { key, kind: 'variable', doc: key.slice(0, slash), name: key.slice(slash + 1) }
}

/** Show the past of a variable in the strip, once. */
export function plot(name: string, doc: string = here.doc): void {
  open(keyOf(name, doc))
}

export function showWorld(name: string): void {
  open(WORLD + name)
}

export function isPlotted(name: string, doc: string = here.doc): boolean {
  return here.plots.some((entry) => cellOf(entry).key === keyOf(name, doc))
}

export const isWorldShown = (name: string): boolean => here.plots.includes(WORLD + name)

export function close(key: string): void {
  here.plots = here.plots.filter((entry) => cellOf(entry).key !== key)
}

/** Show it, or take it away where it is shown. */
export function turn(name: string, doc: string = here.doc): void {
  if (isPlotted(name, doc)) close(keyOf(name, doc))
  else plot(name, doc)
}

function open(key: string): void {
  if (here.plots.some((entry) => cellOf(entry).key === key)) return
  here.plots = [...here.plots, key]
  // For the diary (H01); nobody waits for it.
  void send({ t: 'Note', event: 'open', object: 'plot', id: key, window: 'strip' }).catch(() => undefined)
}
