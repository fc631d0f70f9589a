// Opening and saving: what was opened here comes to the front, and is remembered.
import { act } from './act'
import { desk } from '../link/desk.svelte'
import { canvas } from '../state/canvas.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { look } from '../state/look.svelte'
import { keep, kept } from '../state/kept'
import { goTo, show, shownId, shownOne, type Opened } from './documents.svelte'

const LONGEST = 8

export const recentPaths = (): string[] => kept<string[]>('recent', []).filter((path) => typeof path === 'string')

export function remember(path: string): void {
  keep('recent', [path, ...recentPaths().filter((other) => other !== path)].slice(0, LONGEST))
}

/** Open a configuration or an application beside the others, or go to where it is open already; false where it was refused. */
export async function open(path: string): Promise<boolean> {
  const ids = new Set(Object.keys(all()))
  const id = opened(await act({ t: 'Open', path }), ids) ?? byPath(path)
  if (!id) return false
  show(id)
  remember(all()[id]?.path || path)
  return true
}

export async function openBlank(): Promise<void> {
  const ids = new Set(Object.keys(all()))
  const id = opened(await act({ t: 'New' }), ids)
  if (id) show(id)
}

/** A blank application; false where it was refused. */
export async function openBlankApplication(flows = 1, isParallel = false): Promise<boolean> {
  const ids = new Set(Object.keys(all()))
  const id = opened(await act({ t: 'NewApplication', flows, is_parallel: isParallel }), ids)
  if (id) show(id)
  return id !== undefined
}

const all = (): Readonly<Record<string, Opened>> => ({ ...desk.live.documents, ...desk.live.applications })

/** What an act has opened: what it answered, else what is new. */
function opened(answer: unknown, ids: ReadonlySet<string>): string | undefined {
  if (answer === undefined) return undefined
  return typeof answer === 'string' && answer in all() ? answer : Object.keys(all()).find((id) => !ids.has(id))
}

const byPath = (path: string): string | undefined =>
  Object.entries(all()).find(([, document]) => document.path === path)?.[0]

/** Reconfigure what is shown into another; false where it was refused, or waits for a yes. */
export async function openInPlace(path: string): Promise<boolean> {
  if ((await act({ t: 'OpenInPlace', doc: canvas.doc, path })) === undefined) return false
  remember(path)
  return true
}

/** Bring the tasks of a configuration to life, OFF, beside those of the one shown (C32); false where it was refused. */
export async function keepAlive(path: string): Promise<boolean> {
  return (await act({ t: 'KeepAlive', doc: canvas.doc, path })) !== undefined
}

/** Go to a configuration at the lower level: in the place of one that lives, as in the dissertation; else beside the others. */
export async function goInto(path: string): Promise<void> {
  if (look.isUpperOnly) return goTo('tasks') // which is refused, and says why
  const { connection, application, tasks = {} } = desk.live.documents[canvas.doc] ?? {}
  if (application || connection !== 'live' || !Object.keys(tasks).length) await open(path)
  else if (await openInPlace(path)) show(canvas.doc)
}

/** Look at a configuration as it lives in a subsystem of a running application: it is watched, nothing of it changes. */
export async function lookInto(path: string, subsystem: string): Promise<void> {
  if (look.isUpperOnly) return goTo('tasks') // which is refused, and says why
  if (!(await open(path))) return
  const { application, has_ended, subsystem: shown } = desk.live.documents[canvas.doc] ?? {}
  if (!(application && !has_ended && shown === subsystem)) await act({ t: 'Connect', doc: canvas.doc, subsystem })
}

export function save(): void {
  if (shownOne()?.path) void act({ t: 'Save', doc: shownId() })
  else openDialog('saveAs')
}
