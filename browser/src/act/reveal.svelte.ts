// Going to what a button names: it is selected, and whoever draws it brings it into view.
import { untrack } from 'svelte'
import { desk } from '../link/desk.svelte'
import { canvas, pick } from '../state/canvas.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { look } from '../state/look.svelte'
import { pickSteps, workspace } from '../state/workspace.svelte'

/** What shall be brought into view, and of which document; `turn` grows so that the same can be asked for twice. */
export interface Destination {
  show: string
  doc: string
  turn: number
}

export const destination: Destination = $state({ show: '', doc: '', turn: 0 })

/** Go to what the `show` words of a remedy name: select it, and let whoever draws it bring it into view. */
export function reveal(show: string, doc: string = look.level === 'applications' ? workspace.app : canvas.doc): void {
  const isApplication = doc in desk.tree.applications
  if (isApplication) workspace.app = doc
  else if (doc) canvas.doc = doc
  if (isApplication) look.level = 'applications'
  else if (doc in desk.tree.documents && !look.isUpperOnly) look.level = 'tasks'
  const [kind, name = ''] = cut(show)
  if (kind === 'task') pick(name)
  else if (kind === 'pin') revealPin(name.split('/')[0] ?? '')
  else if (kind === 'library') {
    pick()
    canvas.libraryTask = name
  }
  else if (kind === 'locus') canvas.pickedLocus = name
  else if (kind === 'source') openDialog('source', { task: name, kind: 'code' })
  else if (kind === 'connect') openDialog('connect')
  else if (kind === 'problems') canvas.strip = 'problems'
  else if (kind === 'save-as') openDialog('saveAs')
  else revealUpper(kind, name)
  Object.assign(destination, { show, doc, turn: untrack(() => destination.turn) + 1 })
}

/** The words of applications; the workspace brings steps and places into view, and opens a configuration or what a loop needs. */
function revealUpper(kind: string, name: string): void {
  if (['step', 'fits', 'loop', 'values', 'onikon'].includes(kind)) look.level = 'applications'
  if (kind === 'step' || kind === 'loop') pickSteps(Number(name))
  else if (kind === 'onikon') workspace.onikon = name
  else if (kind === 'target') openDialog('target', { type: name })
  else if (kind === 'values') openDialog('icon', { step: name })
  else if (kind === 'fits') {
    const at = name.lastIndexOf(':')
    workspace.place = { flow: name.slice(0, at), after: Number(name.slice(at + 1)) }
    workspace.fitsOnly = true
  }
}

/** A pin's task stands on the canvas, or else in a library. */
function revealPin(task: string): void {
  if (desk.tree.documents[canvas.doc]?.tasks?.[task]) pick(task)
  else {
    pick()
    canvas.libraryTask = task
  }
}

function cut(show: string): [string, string] {
  const colon = show.indexOf(':')
  return colon < 0 ? [show, ''] : [show.slice(0, colon), show.slice(colon + 1)]
}
