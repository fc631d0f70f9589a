// Opening and saving: what was opened here comes to the front, and is remembered.
import { act } from '../act'
import { desk } from '../desk.svelte'
import { here, openDialog } from '../here.svelte'
import { keep, kept } from '../kept'
import { show, shownDocument } from './documents.svelte'

const LONGEST = 8

export const recentPaths = (): string[] => kept<string[]>('recent', []).filter((path) => typeof path === 'string')

export function remember(path: string): void {
  keep('recent', [path, ...recentPaths().filter((other) => other !== path)].slice(0, LONGEST))
}

/** Open beside the others, or go to where it is open already; false where it was refused. */
export async function open(path: string): Promise<boolean> {
  const known = new Set(Object.keys(desk.tree.documents))
  const value = await act({ t: 'Open', path })
  const doc = typeof value === 'string' && value in desk.tree.documents ? value : newest(known) ?? byPath(path)
  if (!doc) return false
  show(doc)
  remember(desk.tree.documents[doc]?.path || path)
  return true
}

export async function openBlank(): Promise<void> {
  const known = new Set(Object.keys(desk.tree.documents))
  const value = await act({ t: 'New' })
  const doc = typeof value === 'string' && value in desk.tree.documents ? value : newest(known)
  if (doc) show(doc)
}

const newest = (known: ReadonlySet<string>): string | undefined => Object.keys(desk.tree.documents).find((id) => !known.has(id))
const byPath = (path: string): string | undefined =>
  Object.entries(desk.tree.documents).find(([, one]) => one.path === path)?.[0]

/** Reconfigure what is shown into another; false where it was refused, or waits for a yes. */
export async function openInPlace(path: string): Promise<boolean> {
  if ((await act({ t: 'OpenInPlace', doc: here.doc, path })) === undefined) return false
  remember(path)
  return true
}

export function save(): void {
  if (shownDocument()?.path) void act({ t: 'Save', doc: here.doc })
  else openDialog('saveAs')
}
