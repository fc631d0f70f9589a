// Going to what a button names: it is selected, and whoever draws it brings it into view.
import { untrack } from 'svelte'
import type { AnyShow } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { canvas, pick } from '../state/canvas.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { look, type Column } from '../state/look.svelte'
import { pickSteps, workspace } from '../state/workspace.svelte'

/** What shall be brought into view, and of which document; `turn` grows so that the same can be asked for twice. */
export interface Destination {
  show: AnyShow | undefined
  doc: string
  turn: number
}

export const destination: Destination = $state({ show: undefined, doc: '', turn: 0 })

/** Where a narrow page shows what is revealed. */
const COLUMNS: Partial<Record<AnyShow['t'], Column>> = {
  ShowTask: 'desk',
  ShowLocus: 'desk',
  ShowPin: 'right',
  ShowLibraryTask: 'left',
  ShowStep: 'desk',
  ShowLoop: 'desk',
  ShowFits: 'left',
  ShowOnikon: 'left',
}

/** Select what a remedy names, and let whoever draws it bring it into view. */
export function reveal(show: AnyShow, doc: string = look.level === 'applications' ? workspace.app : canvas.doc): void {
  comeTo(doc)
  select(show)
  look.column = COLUMNS[show.t] ?? look.column
  Object.assign(destination, { show, doc, turn: untrack(() => destination.turn) + 1 })
}

function comeTo(doc: string): void {
  if (doc in desk.tree.applications) {
    workspace.app = doc
    look.level = 'applications'
    return
  }
  if (doc) canvas.doc = doc
  if (doc in desk.tree.documents && !look.isUpperOnly) look.level = 'tasks'
}

function select(show: AnyShow): void {
  switch (show.t) {
    case 'ShowTask':
      return pick(show.task)
    case 'ShowPin':
      return selectPin(show.task)
    case 'ShowLibraryTask':
      return selectInLibrary(show.task)
    case 'ShowLocus':
      canvas.pickedLocus = show.svar
      return
    case 'ShowSource':
      return openDialog('source', { task: show.task, kind: 'code', ...(show.line ? { line: String(show.line) } : {}) })
    case 'ShowLibraries':
      return openDialog('open', { what: 'library' })
    case 'ShowConnect':
      return openDialog('connect')
    case 'ShowSaveAs':
      return openDialog('saveAs')
    case 'ShowStep':
    case 'ShowLoop':
      look.level = 'applications'
      return pickSteps(show.step)
    case 'ShowValues':
      look.level = 'applications'
      return openDialog('icon', { step: String(show.step) })
    case 'ShowFits':
      look.level = 'applications'
      Object.assign(workspace, { place: { flow: show.flow, after: show.after }, fitsOnly: true })
      return
    case 'ShowOnikon':
      look.level = 'applications'
      workspace.onikon = show.onikon
      return
    case 'ShowTarget':
      return openDialog('target', { type: show.type })
    case 'ShowAnswer': // the panel of questions, the workspace and the page open these themselves
    case 'ShowConfiguration':
    case 'ShowRecording':
      return
  }
}

/** A pin's task stands on the canvas, or else in a library. */
function selectPin(task: string): void {
  if (desk.tree.documents[canvas.doc]?.tasks?.[task]) pick(task)
  else selectInLibrary(task)
}

function selectInLibrary(task: string): void {
  pick()
  canvas.libraryTask = task
}
