// The cells of the strip beside the table: plots of variables as `DOC/NAME` or `@SUBSYSTEM/NAME`, workcells as `world:NAME`.
import { canvas } from '../state/canvas.svelte'
import { send } from '../link/link'

const WORLD = 'world:'

export type Cell =
  { key: string; kind: 'variable'; doc: string; name: string } | { key: string; kind: 'world'; name: string }

/** The key of a variable; a bare name belongs to the document shown. */
export const keyOf = (name: string, doc: string = canvas.doc): string => (name.includes('/') ? name : `${doc}/${name}`)

export function cellOf(entry: string): Cell {
  if (entry.startsWith(WORLD)) return { key: entry, kind: 'world', name: entry.slice(WORLD.length) }
  const key = keyOf(entry)
  const slash = key.indexOf('/')
  return { key, kind: 'variable', doc: key.slice(0, slash), name: key.slice(slash + 1) }
}

/** Show the past of a variable in the strip, once. */
export function plot(name: string, doc: string = canvas.doc): void {
  open(keyOf(name, doc))
}

export function showWorld(name: string): void {
  open(WORLD + name)
}

export function isPlotted(name: string, doc: string = canvas.doc): boolean {
  return canvas.plots.some((entry) => cellOf(entry).key === keyOf(name, doc))
}

export const isWorldShown = (name: string): boolean => canvas.plots.includes(WORLD + name)

export function close(key: string): void {
  canvas.plots = canvas.plots.filter((entry) => cellOf(entry).key !== key)
}

/** Show it, or take it away where it is shown. */
export function turn(name: string, doc: string = canvas.doc): void {
  if (isPlotted(name, doc)) close(keyOf(name, doc))
  else plot(name, doc)
}

function open(key: string): void {
  if (canvas.plots.some((entry) => cellOf(entry).key === key)) return
  canvas.plots = [...canvas.plots, key]
  // For the diary (H01); nobody waits for it.
  void send({ t: 'Note', event: 'open', object: 'plot', id: key, window: 'strip' }).catch(() => undefined)
}
